// Colour of a black body against an independent table.
// SPDX-License-Identifier: MIT
#include "math/blackbody.h"

#include "math/color.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace facet::math {
namespace {

nlohmann::json rows() {
    std::ifstream file(std::string(FACET_SOURCE_DIR) + "/tests/data/blackbody.json");
    return nlohmann::json::parse(file)["rows"];
}

// Rows hold T, x, y, r, g, b (Y = 1, not clipped), and r, g, b clipped with the largest channel 1.
TEST(Blackbody, ColourEqualsOneNanometreSumsWithinTheGamut) {
    for (const auto& row : rows()) {
        if (row[5].get<float>() < 0.0F) continue;
        const Vec3 color = blackbody_color(row[0].get<float>());
        // The table's steps are 1 nm, ours 5 nm.
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(color[c], row[static_cast<std::size_t>(3 + c)].get<float>(), 1e-3F)
                << row[0] << " K";
    }
}

TEST(Blackbody, RatiosOfChannelsHoldWhereBlueIsOutOfGamut) {
    for (const auto& row : rows()) {
        const Vec3 color = blackbody_color(row[0].get<float>());
        const float largest = std::max({color.x, color.y, color.z});
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(color[c] / largest, row[static_cast<std::size_t>(6 + c)].get<float>(),
                        1e-3F)
                << row[0] << " K";
    }
}

// CIE 1976 u'v', from the table's x and y; where blue is cut there is no such chromaticity to
// compare.
TEST(Blackbody, ChromaticityIsThatOfTheTable) {
    for (const auto& row : rows()) {
        if (row[5].get<double>() < 0.0) continue;
        const Vec3 xyz = xyz_from_rec709(blackbody_color(row[0].get<float>()));
        const auto uv = [](double x, double y) {
            const double d = -2.0 * x + 12.0 * y + 3.0;
            return glm::dvec2(4.0 * x / d, 9.0 * y / d);
        };
        const auto sum = static_cast<double>(xyz.x + xyz.y + xyz.z);
        const glm::dvec2 off =
            uv(static_cast<double>(xyz.x) / sum, static_cast<double>(xyz.y) / sum) -
            uv(row[1].get<double>(), row[2].get<double>());
        EXPECT_LT(glm::length(off), 1e-3) << row[0] << " K";
    }
}

TEST(Blackbody, LuminanceIsOneAndNoChannelIsNegativeAtEveryTemperature) {
    for (float t = blackbody_min_k; t <= blackbody_max_k; t += 50.0F) {
        const Vec3 color = blackbody_color(t);
        EXPECT_NEAR(luminance(color), 1.0F, 1e-5F) << t;
        EXPECT_GE(std::min({color.x, color.y, color.z}), 0.0F) << t;
    }
}

TEST(Blackbody, HotterIsBluerAndLessRed) {
    for (float t = 1100.0F; t <= blackbody_max_k; t += 100.0F) {
        EXPECT_LT(blackbody_color(t).x, blackbody_color(t - 100.0F).x) << t;
        EXPECT_GE(blackbody_color(t).z, blackbody_color(t - 100.0F).z) << t;
    }
}

}  // namespace
}  // namespace facet::math
