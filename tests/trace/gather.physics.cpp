// Light that rays find for a rasteriser's picture, against closed forms.
// SPDX-License-Identifier: MIT
#include "support/trace_harness.h"
#include "trace/smooth.h"

#include <gtest/gtest.h>

namespace facet::test {
namespace {

using math::Vec3;
using trace::IndirectPixels;
using trace::Seen;

/// A floor of 40 m, and a wall of that size that stands on its left edge at x = 0; both face where
/// the other is.
scene::Scene floor_and_wall(const scene::Material& wall) {
    scene::Scene scene = scene_of(quad(40.0F));
    scene.materials.front().values.metallic = 0.0F;
    scene.materials.front().values.roughness = 1.0F;
    const auto turn = [](float degrees, const Vec3& axis) {
        return glm::rotate(math::Mat4(1.0F), glm::radians(degrees), axis);
    };
    scene.instances.front().world_from_object =
        glm::translate(math::Mat4(1.0F), Vec3(20, 0, 0)) * turn(-90.0F, Vec3(1, 0, 0));
    add(scene, scene.meshes.front(), wall,
        glm::translate(math::Mat4(1.0F), Vec3(0, 20, 0)) * turn(90.0F, Vec3(0, 1, 0)));
    return scene;
}

/// A row of pixels on the floor, from x = 0.5 m on, 1 m apart, seen from straight above.
Seen look_down(std::uint32_t width) {
    Seen seen;
    seen.size = {width, 1};
    seen.picture_width = width;
    seen.is_perspective = false;
    seen.forward = Vec3(0, -1, 0);
    seen.pixel_m = 1.0F;
    const auto half = static_cast<float>(width) * 0.5F;
    seen.eye_m = Vec3(half, 5, 0);
    // x to the right, depth down from 5 m above.
    math::Mat4 m(0.0F);
    m[0] = {half, 0, 0, 0};
    m[1] = {0, 0, -0.5F, 0};
    m[2] = {0, -5, 0, 0};
    m[3] = {half, 0, 0, 1};
    seen.world_from_clip = m;
    seen.pixels.resize(width);
    for (std::uint32_t x = 0; x < width; ++x)
        seen.pixels[x] = {.instance = 0,
                          .triangle = 1,
                          .normal = Vec3(0, 1, 0),
                          .base_color = Vec3(1.0F),
                          .metallic = 0.0F,
                          .roughness = 1.0F};
    return seen;
}

IndirectPixels gathered(const scene::Scene& scene, const Seen& seen, std::uint32_t samples,
                        unsigned threads = 0) {
    base::ThreadPool pool(threads);
    const scene::Environment environment{"test", constant_environment(Vec3(1.0F))};
    const scene::Camera camera = camera_on_z(4.0F, 1.0F);
    const auto tracer = trace::Tracer::create(
        {.scene = scene, .environment = environment, .camera = camera}, {}, pool);
    if (!tracer) {
        ADD_FAILURE() << base::to_line(tracer.error());
        return {};
    }
    return tracer->gather(seen, {.samples = samples, .most_samples = samples}, pool);
}

// Beside a wall of height h, at distance d, (1 + d / sqrt(d^2 + h^2)) / 2 of an even sky is left
// (the form factor of a strip without ends; Howell, "Radiation Configuration Factors", C-5).
TEST(Gather, ABlackWallLeavesTheShareOfTheSkyThatItsFormFactorLeaves) {
    scene::Material black;
    black.values.base_color = Vec3(0.0F);
    black.values.metallic = 1.0F;  // no specular lobe either
    const Seen seen = look_down(4);
    const IndirectPixels light = gathered(floor_and_wall(black), seen, 4096);
    for (std::uint32_t x = 0; x < 4; ++x) {
        const float d = static_cast<float>(x) + 0.5F;
        const float expected = 0.5F * (1.0F + d / std::sqrt(d * d + 1600.0F));
        // The wall has ends, 20 m to each side.
        EXPECT_NEAR(light.sky[x].x, expected, 0.025F) << d;
        EXPECT_NEAR(light.rest[x].x, 0.0F, 6e-3F) << d;  // at grazing angles black mirrors
    }
}

TEST(Gather, InAWhiteFurnaceWhatAWhiteWallHidesItSendsItself) {
    scene::Material white;
    white.values.metallic = 0.0F;
    white.values.roughness = 1.0F;
    const Seen seen = look_down(4);
    const IndirectPixels light = gathered(floor_and_wall(white), seen, 2048);
    for (std::uint32_t x = 0; x < 4; ++x)
        EXPECT_NEAR(light.sky[x].x + light.rest[x].x, 1.0F, 0.02F) << x;
}

TEST(Gather, BytesDoNotDependOnTheNumberOfThreads) {
    const scene::Scene scene = floor_and_wall({});
    const Seen seen = look_down(64);
    const IndirectPixels one = gathered(scene, seen, 4, 1);
    const IndirectPixels five = gathered(scene, seen, 4, 5);
    EXPECT_EQ(one.sky, five.sky);
    EXPECT_EQ(one.rest, five.rest);
    EXPECT_EQ(one.specular, five.specular);
}

struct AllLights final : trace::LightChoice {
    std::vector<std::uint16_t> indices;
    [[nodiscard]] std::span<const std::uint16_t> at(std::uint32_t, std::uint32_t) const override {
        return indices;
    }
};

TEST(LightVisibility, AWallShadesTheFloorAsFarAsItsHeightOverTheTangent) {
    scene::Scene scene = floor_and_wall({});
    // From beyond the wall, 84 degrees above: 40 m of wall shade 40 / tan(84 deg) = 4.2 m.
    scene.lights.push_back({.kind = tables::LightKind::directional,
                            .direction = -math::direction_from(-90.0F, 84.0F)});
    // Beside the floor's middle, 1 m above it, in front of the wall: nothing is in its way.
    scene.lights.push_back({.kind = tables::LightKind::point, .position_m = {2.0F, 1.0F, 0.0F}});
    // Behind the wall.
    scene.lights.push_back({.kind = tables::LightKind::point, .position_m = {-1.0F, 1.0F, 0.0F}});
    base::ThreadPool pool(2);
    const scene::Environment environment{"test", constant_environment(Vec3(0.0F))};
    const scene::Camera camera = camera_on_z(4.0F, 1.0F);
    const auto tracer = trace::Tracer::create(
        {.scene = scene, .environment = environment, .camera = camera}, {}, pool);
    ASSERT_TRUE(tracer);
    AllLights lights;
    lights.indices = {0, 1, 2};
    const auto shares = tracer->light_visibility(look_down(8), lights, 3, {}, pool);
    ASSERT_EQ(shares.size(), 96U);
    for (std::size_t x = 0; x < 8; ++x)
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_EQ(shares[x * 4 + c], x < 4 ? 0 : 255) << x;
            EXPECT_EQ(shares[(8 + x) * 4 + c], 255) << x;
            EXPECT_EQ(shares[(16 + x) * 4 + c], 0) << x;
        }
}

std::vector<trace::GatherPoint> plane_points(std::uint32_t side) {
    std::vector<trace::GatherPoint> points;
    for (std::uint32_t i = 0; i < side * side; ++i)
        points.push_back({.position_m = Vec3(i % side, i / side, 0),
                          .normal = Vec3(0, 0, 1),
                          .spacing_m = 1.0F,
                          .is_surface = true});
    return points;
}

TEST(Smooth, LeavesEvenLightAndTakesNoiseOut) {
    constexpr std::uint32_t side = 32;
    const auto points = plane_points(side);
    std::vector<trace::GatheredMeans> means(side * side);
    double before = 0.0;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        const float noise = static_cast<float>(i * 2654435761U >> 8U) / 16777216.0F - 0.5F;
        means[i] = {.sky = Vec3(2.0F),
                    .open = Vec3(4.0F),
                    .rest = Vec3(1.0F + noise),
                    .diffuse_variance = 1.0F / 12.0F,
                    .has_diffuse = 1.0F,
                    .has_specular = 1.0F};
        before += static_cast<double>(noise * noise);
    }
    base::ThreadPool pool(2);
    trace::smooth({side, side}, points, means, 4, pool);
    double after = 0.0;
    for (const auto& mean : means) {
        EXPECT_NEAR(mean.sky.x, 2.0F, 1e-4F);
        EXPECT_NEAR(mean.open.x, 4.0F, 1e-4F);
        after += static_cast<double>((mean.rest.x - 1.0F) * (mean.rest.x - 1.0F));
    }
    EXPECT_LT(after, 0.02 * before);
}

TEST(Smooth, MixesNothingAcrossAStepOrABend) {
    constexpr std::uint32_t side = 16;
    auto points = plane_points(side);
    std::vector<trace::GatheredMeans> means(side * side);
    for (std::uint32_t i = 0; i < side * side; ++i) {
        const std::uint32_t x = i % side;
        if (x >= 10) points[i].normal = Vec3(1, 0, 0);  // a bend
        if (x < 5) points[i].position_m.z = -20.0F;     // a step
        means[i] = {.rest = Vec3(x < 5    ? 1.0F
                                 : x < 10 ? 2.0F
                                          : 3.0F),
                    .diffuse_variance = 100.0F,  // nothing is certain
                    .has_diffuse = 1.0F,
                    .has_specular = 1.0F};
    }
    base::ThreadPool pool(2);
    trace::smooth({side, side}, points, means, 4, pool);
    for (std::uint32_t i = 0; i < side * side; ++i) {
        const std::uint32_t x = i % side;
        EXPECT_NEAR(means[i].rest.x, x < 5 ? 1.0F : x < 10 ? 2.0F : 3.0F, 1e-5F) << x;
    }
}

}  // namespace
}  // namespace facet::test
