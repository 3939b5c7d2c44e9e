// Cube-map places, half floats and sample points.
// SPDX-License-Identifier: MIT
#include "math/sampling.h"

#include "math/cube_map.h"
#include "math/half.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace facet::math {
namespace {

TEST(CubeMap, DirectionOfAPlaceLeadsBackToThatPlace) {
    for (std::uint32_t face = 0; face < 6; ++face)
        for (float s = -0.95F; s < 1.0F; s += 0.19F)
            for (float t = -0.95F; t < 1.0F; t += 0.19F) {
                const CubePoint back =
                    cube_point_from(3.0F * direction_from(CubePoint{face, s, t}));
                EXPECT_EQ(back.face, face);
                EXPECT_NEAR(back.s, s, 1e-6F);
                EXPECT_NEAR(back.t, t, 1e-6F);
            }
}

// OpenGL 4.5, table 8.19: major axis, sc and tc of each face.
TEST(CubeMap, FacesAreOrientedAsOpenGlSays) {
    EXPECT_EQ(direction_from(CubePoint{0, 0.5F, 0.25F}), Vec3(1.0F, -0.25F, -0.5F));
    EXPECT_EQ(direction_from(CubePoint{1, 0.5F, 0.25F}), Vec3(-1.0F, -0.25F, 0.5F));
    EXPECT_EQ(direction_from(CubePoint{2, 0.5F, 0.25F}), Vec3(0.5F, 1.0F, 0.25F));
    EXPECT_EQ(direction_from(CubePoint{3, 0.5F, 0.25F}), Vec3(0.5F, -1.0F, -0.25F));
    EXPECT_EQ(direction_from(CubePoint{4, 0.5F, 0.25F}), Vec3(0.5F, -0.25F, 1.0F));
    EXPECT_EQ(direction_from(CubePoint{5, 0.5F, 0.25F}), Vec3(-0.5F, -0.25F, -1.0F));
}

TEST(Half, EveryFiniteHalfSurvivesTheWayToFloatAndBack) {
    for (std::uint32_t bits = 0; bits < 0x7C00U; ++bits)
        ASSERT_EQ(half_from_radiance(float_from_half(static_cast<std::uint16_t>(bits))), bits);
}

TEST(Half, ValuesBetweenTwoHalvesGoToTheNearerAndTiesToEven) {
    for (std::uint32_t bits = 0; bits < 0x7BFEU; bits += 7) {
        const float low = float_from_half(static_cast<std::uint16_t>(bits));
        const float high = float_from_half(static_cast<std::uint16_t>(bits + 1));
        EXPECT_EQ(half_from_radiance(low + 0.25F * (high - low)), bits);
        EXPECT_EQ(half_from_radiance(low + 0.75F * (high - low)), bits + 1);
        EXPECT_EQ(half_from_radiance(low + 0.5F * (high - low)), bits + (bits & 1U)) << bits;
    }
}

TEST(Half, SignInfinityAndNotANumberAreReadAsTheyAre) {
    EXPECT_EQ(float_from_half(0xC000), -2.0F);
    EXPECT_EQ(float_from_half(0x7C00), std::numeric_limits<float>::infinity());
    EXPECT_TRUE(std::isnan(float_from_half(0x7E00)));
}

TEST(Hammersley, EveryStratumOfBothAxesHoldsOnePoint) {
    constexpr std::uint32_t count = 64;
    std::vector<int> x(count);
    std::vector<int> y(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 p = hammersley(i, count);
        ++x[static_cast<std::size_t>(p.x * count)];
        ++y[static_cast<std::size_t>(p.y * count)];
    }
    EXPECT_TRUE(std::all_of(x.begin(), x.end(), [](int n) { return n == 1; }));
    EXPECT_TRUE(std::all_of(y.begin(), y.end(), [](int n) { return n == 1; }));
}

// The mean of f(h) / pdf over the samples is the integral of f; with f = D(h) (n.h) itself: 1 for
// any alpha, and the mean cosine has the closed form of the integral of D (n.h)^2, done here by the
// midpoint rule.
TEST(GgxSampling, MeanCosineOfTheSamplesIsThatOfTheDensity) {
    for (const float alpha : {0.01F, 0.1F, 0.5F, 1.0F}) {
        double sampled = 0.0;
        constexpr std::uint32_t count = 4096;
        for (std::uint32_t i = 0; i < count; ++i)
            sampled +=
                static_cast<double>(ggx_sample_cosine(hammersley(i, count).x, alpha)) / count;
        double expected = 0.0;
        constexpr int steps = 200000;
        for (int i = 0; i < steps; ++i) {
            const double c = (i + 0.5) / steps;
            const auto density = static_cast<double>(ggx_density(static_cast<float>(c), alpha));
            expected += density * c * c * 2.0 * static_cast<double>(pi) / steps;
        }
        EXPECT_NEAR(sampled, expected, 2e-3) << alpha;
    }
}

}  // namespace
}  // namespace facet::math
