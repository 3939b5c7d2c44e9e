// The settings of a request, understood or refused before any work starts.
// SPDX-License-Identifier: MIT
#include "render/plan.h"

#include <gtest/gtest.h>

namespace facet::render {
namespace {

using base::ErrorCode;

/// The error that `change` of the default settings gives; fails the test where there is none.
template <class Change>
base::Error refusal(const Change& change) {
    tables::Settings settings;
    change(settings);
    const auto plan = make_plan(settings);
    EXPECT_FALSE(plan);
    return plan ? base::Error{} : plan.error();
}

TEST(Plan, DefaultsAreEightSamplesOfTheWholePictureWithAutomaticExposure) {
    const auto plan = make_plan({});
    ASSERT_TRUE(plan) << base::to_line(plan.error());
    EXPECT_EQ(plan->picture, (math::Extent{1280, 720}));
    EXPECT_EQ(plan->region.size, plan->picture);
    EXPECT_EQ(plan->sample_count, 8U);
    EXPECT_FALSE(plan->exposure);
}

TEST(Plan, AnExposureValueIsOneFactorOnNit) {
    tables::Settings settings;
    settings.ev = 3.0F;
    const auto plan = make_plan(settings);
    ASSERT_TRUE(plan && plan->exposure);
    EXPECT_NEAR(*plan->exposure, 1.0 / (1.2 * 8.0), 1e-12);  // ISO 12232, q = 0.65
}

TEST(Plan, EvAndExposureExcludeEachOther) {
    const auto error = refusal([](auto& s) {
        s.ev = 3.0F;
        s.exposure = "2";
    });
    EXPECT_EQ(error.code, ErrorCode::usage);
}

TEST(Plan, ARegionMustLieWithinThePicture) {
    for (const char* text : {"1200,0,81x10", "0,700,10x21", "-1,0,10x10", "0,0,0x10", "0,0,10",
                             "a,b,cxd", "0,0,1280x99999999999999999999"}) {
        const auto error = refusal([&](auto& s) { s.region = text; });
        EXPECT_EQ(error.code, ErrorCode::usage) << text;
        EXPECT_EQ(error.file, "--region") << text;
    }
    tables::Settings settings;
    settings.region = "1200,700,80x20";
    EXPECT_TRUE(make_plan(settings));
}

TEST(Plan, AColourOfTheBackgroundIsSixHexDigits) {
    for (const char* text :
         {"#12345", "#1234567", "#12345g", "#+1+1+1", "123456", "blur:2", "blur:x", "blue"})
        EXPECT_EQ(refusal([&](auto& s) { s.background = text; }).file, "--background") << text;
    tables::Settings settings;
    settings.background = "#808080";
    const auto plan = make_plan(settings);
    ASSERT_TRUE(plan);
    EXPECT_NEAR(plan->background.color.x, 0.2158605F, 1e-5F);  // IEC 61966-2-1 of 128/255
}

TEST(Plan, AFrameThatDoesNotFitIntoMemoryIsRefusedAndFitsInParts) {
    const auto error = refusal([](auto& s) { s.size = {16384, 16384}; });
    EXPECT_EQ(error.code, ErrorCode::limit_reached);
    tables::Settings settings;
    settings.size = {16384, 16384};
    settings.region = "0,0,1024x1024";
    EXPECT_TRUE(make_plan(settings));
}

TEST(Plan, AMisspeltNameIsAnsweredWithTheNearestOne) {
    EXPECT_EQ(refusal([](auto& s) { s.tonemap = "agxx"; }).remedy, "did you mean agx");
    EXPECT_EQ(refusal([](auto& s) { s.aov = {"normals"}; }).remedy, "did you mean normal");
}

}  // namespace
}  // namespace facet::render
