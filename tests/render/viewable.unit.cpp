// AOVs as pictures that a person can look at.
// SPDX-License-Identifier: MIT
#include "render/viewable.h"

#include <gtest/gtest.h>

#include <cmath>

namespace facet::render {
namespace {

using tables::Aov;

/// Red of the pixels that these values of an AOV become.
std::vector<int> shown(Aov aov, std::vector<float> values, double exposure = 1.0) {
    const tables::AovRow& row = tables::row(aov);
    const auto channels = static_cast<std::uint32_t>(row.channels.size());
    const math::Extent size{static_cast<std::uint32_t>(values.size()), 1};
    image::Image picture(size, channels, image::Sample::f32);
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t c = 0; c < channels; ++c)
            picture.as<float>()[i * channels + c] = values[i];
    const image::Image out =
        viewable(aov, image::layer_of(row.key, row.channels, picture), exposure);
    EXPECT_EQ(out.channels, 3U);
    EXPECT_EQ(out.size, size);
    std::vector<int> red;
    for (std::size_t i = 0; i < values.size(); ++i) red.push_back(out.as<std::uint8_t>()[i * 3]);
    return red;
}

TEST(Viewable, NumbersAreCodesAndColoursAreEncoded) {
    EXPECT_EQ(shown(Aov::roughness, {0.0F, 0.2F, 1.0F, 7.0F}), (std::vector{0, 51, 255, 255}));
    EXPECT_EQ(shown(Aov::normal, {-1.0F, 0.0F, 1.0F}), (std::vector{0, 128, 255}));
    EXPECT_EQ(shown(Aov::albedo, {0.18F}), (std::vector{118})) << "contract: 0.18 is sRGB 118";
}

// D / (1 + D): the same grey for the same D in every picture.
TEST(Viewable, WhatHasNoEndIsCompressed) {
    EXPECT_EQ(shown(Aov::D, {0.0F, 1.0F, 4.0F, INFINITY}), (std::vector{0, 128, 204, 255}));
}

TEST(Viewable, ARangeIsThePicturesOwnAndTheFarthestWhite) {
    EXPECT_EQ(shown(Aov::depth, {2.0F, 3.0F, 4.0F, INFINITY}), (std::vector{0, 128, 255, 255}));
}

TEST(Viewable, ExposureIsForRadianceAlone) {
    EXPECT_EQ(shown(Aov::albedo, {0.18F}, 4.0), (std::vector{118}));
    EXPECT_EQ(shown(Aov::diffuse_direct, {0.045F, 90.0F}, 4.0), (std::vector{118, 255}));
}

}  // namespace
}  // namespace facet::render
