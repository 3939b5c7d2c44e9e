// The environment's draw against its density, and against what it integrates to.
// SPDX-License-Identifier: MIT
#include "trace/environment_light.h"

#include "trace/sequence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace facet::trace {
namespace {

using math::Vec3;
using std::numbers::pi;

image::Image picture(std::uint32_t height, float (*nit)(std::uint32_t x, std::uint32_t y)) {
    image::Image out({2 * height, height}, 3, image::Sample::f32);
    const auto values = out.as<float>();
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < 2 * height; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                values[(std::size_t{y} * 2 * height + x) * 3 + c] =
                    nit(x, y) * static_cast<float>(c + 1);
    return out;
}

float lone_pixel(std::uint32_t x, std::uint32_t y) { return x == 40 && y == 21 ? 1e4F : 0.0F; }
float mottled(std::uint32_t x, std::uint32_t y) {
    return static_cast<float>((x * 7 + y * 13) % 11);
}

TEST(Distribution, DrawsEachCellAsOftenAsItsWeightAndNeverAnEmptyOne) {
    const std::vector<float> weights{0.0F, 3.0F, 0.0F, 1.0F, 4.0F, 0.0F};
    const Distribution distribution{std::span<const float>(weights)};
    std::vector<int> counts(weights.size());
    constexpr int draws = 8000;
    for (int i = 0; i < draws; ++i) {
        const auto draw = distribution.draw((static_cast<float>(i) + 0.5F) / draws);
        ++counts[draw.cell];
        EXPECT_EQ(draw.share, distribution.share(draw.cell));
    }
    for (std::size_t i = 0; i < weights.size(); ++i)
        EXPECT_NEAR(counts[i], weights[i] / 8.0F * draws, 1.0F) << i;
}

TEST(Distribution, WithoutAnyWeightEveryCellIsAsLikely) {
    const std::vector<float> weights(5, 0.0F);
    const Distribution distribution{std::span<const float>(weights)};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(distribution.share(i), 0.2F, 1e-6F);
}

TEST(EnvironmentLight, MiddleColumnIsMinusZAndColumnsToItsRightTurnTowardsPlusX) {
    base::ThreadPool pool;
    const image::Image map = picture(64, [](std::uint32_t x, std::uint32_t y) {
        return static_cast<float>(x) + 1000.0F * static_cast<float>(y);
    });
    const EnvironmentLight still(map, 0.0F, 1.0F, pool);
    EXPECT_NEAR(still.at({0, 0, -1}).radiance_nit.x, 31500.0F + 63.5F, 0.1F);
    EXPECT_NEAR(still.at({1, 0, 0}).radiance_nit.x, 31500.0F + 95.5F, 0.1F);
    // Counter-clockwise seen from above: what was at -z comes to -x.
    const EnvironmentLight turned(map, 90.0F, 2.0F, pool);
    EXPECT_NEAR(turned.at({-1, 0, 0}).radiance_nit.x, 2.0F * (31500.0F + 63.5F), 0.2F);
}

TEST(EnvironmentLight, DensityOfADrawIsTheDensityLookedUpAndIntegratesToOne) {
    base::ThreadPool pool;
    const image::Image map = picture(64, mottled);
    const EnvironmentLight light(map, 30.0F, 1.0F, pool);
    for (std::uint32_t i = 0; i < 1000; ++i) {
        Sequence sequence(0, i, 0);
        const auto sample = light.sample(sequence.next_pair());
        const auto found = light.at(sample.direction);
        // A draw within a rounding of a cell's edge is looked up in the next cell: a few in a
        // thousand.
        if (std::fabs(found.pdf - sample.light.pdf) > 1e-3F * found.pdf) continue;
        EXPECT_NEAR(found.radiance_nit.x, sample.light.radiance_nit.x, 0.02F);
    }
    double sum = 0.0;
    constexpr int side = 512;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < 2 * side; ++x) {
            const double polar = (y + 0.5) / side * pi;
            const double azimuth = (x + 0.5) / side * pi;
            const Vec3 d(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                         std::sin(polar) * std::cos(azimuth));
            sum +=
                static_cast<double>(light.at(d).pdf) * std::sin(polar) * (pi / side) * (pi / side);
        }
    EXPECT_NEAR(sum, 1.0, 1e-3);  // midpoints see the edges of cells within half a step
}

TEST(EnvironmentLight, SampledFluxOfALonePixelIsItsRadianceTimesItsSolidAngle) {
    base::ThreadPool pool;
    const image::Image map = picture(64, lone_pixel);
    const EnvironmentLight light(map, 0.0F, 1.0F, pool);
    // Bilinear in azimuth and polar angle, not in solid angle: the row's neighbours weigh in with
    // their own sines.
    double expected = 0.0;
    constexpr int fine = 200;
    for (int i = 0; i < fine; ++i) {
        const double offset = (i + 0.5) / fine * 2.0 - 1.0;
        const double polar = (21.5 + offset) / 64.0 * pi;
        expected += 1e4 * (1.0 - std::fabs(offset)) * std::sin(polar) * (2.0 / fine);
    }
    expected *= (pi / 64.0) * (pi / 64.0);
    double sum = 0.0;
    constexpr std::uint32_t draws = 4096;
    for (std::uint32_t i = 0; i < draws; ++i) {
        Sequence sequence(5, i, 0);
        const auto sample = light.sample(sequence.next_pair());
        if (sample.light.pdf > 0.0F)
            sum += static_cast<double>(sample.light.radiance_nit.x) /
                   static_cast<double>(sample.light.pdf);
    }
    EXPECT_NEAR(sum / draws, expected, 0.01 * expected);
}

}  // namespace
}  // namespace facet::trace
