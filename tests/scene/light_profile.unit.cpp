// IES profiles: what a file says, completed by symmetry, by closed forms.
// SPDX-License-Identifier: MIT
#include "scene/light_profile.h"

#include "math/vector.h"
#include "scene/builtin_files.h"
#include "scene/light_spec.h"

#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace facet::scene {
namespace {

constexpr const char* head = "IESNA:LM-63-2002\n[TEST] own figures\nTILT=NONE\n1 -1 ";

/// A round lamp whose candela follow `of` the polar angle in radians, one degree apart.
std::string round_lamp(double factor, double (*of)(double)) {
    std::string text = fmt::format("{}{} 181 1 1 2 0 0 0\n1 1 10\n", head, factor);
    for (int degree = 0; degree <= 180; ++degree) text += fmt::format("{}\n", degree);
    text += "0\n";
    for (int degree = 0; degree <= 180; ++degree)
        text += fmt::format("{:.6f}, ", std::max(of(degree * 3.14159265358979 / 180.0), 0.0));
    return text;
}

LightProfile parsed(const std::string& text) {
    auto profile = parse_profile(text);
    if (!profile) ADD_FAILURE() << base::to_line(profile.error());
    return profile.value_or(LightProfile{});
}

Light lamp(LightProfile profile) {
    Light light{.kind = tables::LightKind::ies, .direction = {0.0F, -1.0F, 0.0F}};
    light.profile = std::make_shared<const LightProfile>(std::move(profile));
    return light;
}

/// Down by `polar_deg`, turned by `azimuth_deg` from +x towards -z.
Vec3 way(float polar_deg, float azimuth_deg) {
    const float p = glm::radians(polar_deg);
    const float a = glm::radians(azimuth_deg);
    return {std::sin(p) * std::cos(a), -std::cos(p), -std::sin(p) * std::sin(a)};
}

TEST(LightProfile, FluxIsThatOfTheClosedForms) {
    const LightProfile even = parsed(round_lamp(2.0, [](double) { return 5.0; }));
    EXPECT_FLOAT_EQ(even.candela, 10.0F);
    EXPECT_NEAR(even.flux_per_candela, 4.0F * math::pi, 1e-3F);
    const LightProfile cosine = parsed(round_lamp(1.0, [](double p) { return std::cos(p); }));
    EXPECT_NEAR(cosine.flux_per_candela, math::pi, 1e-3F);
}

TEST(LightProfile, ShareFollowsTheMeasuredAngles) {
    const Light light = lamp(parsed(round_lamp(1.0, [](double p) { return std::cos(p); })));
    for (const float polar : {0.0F, 12.3F, 45.0F, 89.0F})
        EXPECT_NEAR(profile_share(light, way(polar, 77.0F)), std::cos(glm::radians(polar)), 1e-3F);
    EXPECT_EQ(profile_share(light, way(120.0F, 0.0F)), 0.0F);
}

/// Horizontal angles of one file, each with its own even candela; by symmetry what 30, 150, 210 and
/// 330 degrees show.
struct Symmetry {
    std::string angles;
    std::string candela;  ///< of each angle, at 0 and at 90 degrees down
    std::array<float, 4> shown;
};
TEST(LightProfile, SymmetryCompletesTheRest) {
    const Symmetry cases[] = {
        {"1 1 2 0 0 0\n1 1 0\n0 90\n0\n", "4 4", {4, 4, 4, 4}},
        {"3 1 2 0 0 0\n1 1 0\n0 90\n0 30 90\n", "1 1 2 2 4 4", {2, 2, 2, 2}},
        {"4 1 2 0 0 0\n1 1 0\n0 90\n0 30 150 180\n", "1 1 2 2 3 3 4 4", {2, 3, 3, 2}},
        {"4 1 2 0 0 0\n1 1 0\n0 90\n90 150 210 270\n", "1 1 2 2 3 3 4 4", {2, 2, 3, 3}},
        {"6 1 2 0 0 0\n1 1 0\n0 90\n0 30 150 210 330 360\n",
         "0 0 1 1 2 2 3 3 4 4 0 0",
         {1, 2, 3, 4}},
    };
    for (const Symmetry& c : cases) {
        const LightProfile profile = parsed(fmt::format("{}1 2 {}{}\n", head, c.angles, c.candela));
        const float most = profile.candela;
        const Light light = lamp(profile);
        const std::array<float, 4> azimuths = {30.0F, 150.0F, 210.0F, 330.0F};
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(profile_share(light, way(60.0F, azimuths[i])) * most, c.shown[i], 1e-3F)
                << c.angles << azimuths[i];
    }
}

TEST(LightProfile, IsOnlyReadWhereItIsWhole) {
    const auto refused = [](const std::string& text) {
        const auto profile = parse_profile(text);
        EXPECT_FALSE(profile) << text;
        return profile ? std::string() : base::to_line(profile.error());
    };
    EXPECT_NE(refused("").find("empty"), std::string::npos);
    EXPECT_NE(refused("\x7F"
                      "ELF\n")
                  .find("not an IES file"),
              std::string::npos);
    EXPECT_NE(refused("IESNA91\n[A] b\n").find("TILT"), std::string::npos);
    refused("IESNA91\nTILT=other.tlt\n1 1 1 1 1 1 1 0 0 0 1 1 1\n0\n0\n1\n");
    const std::string rest = " 1 2 0 0 0\n1 1 0\n";
    refused(head + std::string("1 2 1") + rest + "0 90 0 5");           // ends early
    refused(head + std::string("1 2 1") + rest + "90 0 0 5 5");         // angles fall
    refused(head + std::string("1 2 1") + rest + "0 80 0 5 5");         // to nowhere
    refused(head + std::string("1 2 1") + rest + "0 90 0 5 -5");        // dark light
    refused(head + std::string("1 2 1") + rest + "0 90 0 0 0");         // no light
    refused(head + std::string("1 2 1") + rest + "0 90 0 5 nan");       // no number
    refused(head + std::string("1 1e9 1e9") + rest + "0 90 0 5 5");     // more than there is
    refused(head + std::string("1 2.5 1") + rest + "0 90 0 5 5");       // half an angle
    refused(head + std::string("1 2 1 3 2 0 0 0\n1 1 0\n0 90 0 5 5"));  // type A
    EXPECT_TRUE(parse_profile(head + std::string("1 2 1") + rest + "0 90 0 5 5"));
}

TEST(LightProfile, SetsTheCandelaOfItsLight) {
    const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "cosine.ies";
    std::ofstream(file) << round_lamp(30.0, [](double p) { return std::cos(p); });
    const auto own = parse_light("ies:file=" + file.string());
    ASSERT_TRUE(own) << base::to_line(own.error());
    EXPECT_NEAR(own->intensity, 30.0F, 1e-4F);
    const auto lumen = parse_light("ies:lumen=100,file=" + file.string());
    ASSERT_TRUE(lumen);
    EXPECT_NEAR(lumen->intensity, 100.0F / math::pi, 0.02F);
    EXPECT_EQ(light_key_text(*own, "file"), file.string());
    EXPECT_FALSE(parse_light("ies:file=nowhere.ies"));

    ASSERT_EQ(builtin_names(builtin_lamps).size(), 3U);
    for (const std::string& name : builtin_names(builtin_lamps)) {
        const auto lamp = parse_light("ies:file=builtin:" + name);
        ASSERT_TRUE(lamp) << name;
        EXPECT_EQ(lamp->intensity, 1000.0F) << name;
        EXPECT_EQ(light_key_text(*lamp, "file"), "builtin:" + name);
    }
    const auto unknown = parse_light("ies:file=builtin:downlihgt");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, base::ErrorCode::usage);
    EXPECT_NE(unknown.error().remedy.find("downlight"), std::string::npos);
    EXPECT_FALSE(parse_light("point:file=" + file.string()));
    std::filesystem::remove(file);
}

TEST(LightProfile, FileOfALightIsChangedInItsText) {
    const auto other = [](const std::string& file) {
        return base::Result<std::string>("a/" + file);
    };
    EXPECT_EQ(*with_light_file("ies:name=x, file = b.ies,lumen=3", other),
              "ies:name=x,file=a/b.ies,lumen=3");
    EXPECT_EQ(*with_light_file("point:candela=2", other), "point:candela=2");
    EXPECT_EQ(*with_light_file("point", other), "point");
}

}  // namespace
}  // namespace facet::scene
