// Lights on surfaces whose answer is known on paper.
// SPDX-License-Identifier: MIT
#include "brdf/choice.h"
#include "support/frame_harness.h"

#include <gtest/gtest.h>

namespace facet::test {
namespace {

// Quantisation bounds these: albedo 16 bits, normals 2 x 16 bits (4e-5 rad), and a picture's pixel
// that sees the plane half a pixel from its middle: cos^3 of 1/64 over the nearest light's
// distance, 1e-3.
constexpr float albedo_share = 2e-3F;

/// Lambert alone: no Fresnel, no specular lobe to see past.
tables::BrdfChoice lambert_only() {
    const auto choice = brdf::parse_choice("fresnel=none,multiscatter=off", brdf::Use::render);
    EXPECT_TRUE(choice);
    return *choice;
}

scene::Light directional(float lux, math::Vec3 towards) {
    return {.kind = tables::LightKind::directional,
            .intensity = lux,
            .direction = -math::normalize(towards)};
}

/// Radiance of the default model's diffuse lobe and specular lobe is what is asked for elsewhere;
/// here a black base colour leaves the specular lobe, and the difference to a gray one is the
/// diffuse lobe alone.
float diffuse_radiance(Harness& harness, Shot shot, float albedo) {
    shot.scene.materials[0] = material(math::Vec3(albedo), 0.0F, 1.0F);
    const auto gray = harness.draw(shot);
    shot.scene.materials[0] = material(math::Vec3(0.0F), 0.0F, 1.0F);
    const auto black = harness.draw(shot);
    EXPECT_TRUE(gray && black);
    return gray && black ? gray->center().x - black->center().x : -1.0F;
}

// L = c/pi * E * cos(theta) with k_d = 1 (physics: 5.2, 10.5).
TEST(Lights, ADirectionalLightOnALambertPlaneFollowsTheCosineLaw) {
    Harness harness;
    for (const float angle_deg : {0.0F, 30.0F, 60.0F, 80.0F}) {
        Shot shot{.scene = scene_of(quad(4.0F)), .brdf = lambert_only()};
        const float angle = glm::radians(angle_deg);
        shot.scene.lights = {directional(10.0F, {std::sin(angle), 0.0F, std::cos(angle)})};
        const float expected = 0.5F / math::pi * 10.0F * std::cos(angle);
        EXPECT_NEAR(diffuse_radiance(harness, shot, 0.5F), expected, expected * albedo_share)
            << angle_deg;
    }
}

// E = I / d^2 (KHR_lights_punctual).
TEST(Lights, APointLightFollowsTheInverseSquareLaw) {
    Harness harness;
    for (const float distance_m : {0.5F, 1.0F, 2.0F, 4.0F}) {
        Shot shot{.scene = scene_of(quad(4.0F)), .size = {65, 65}, .brdf = lambert_only()};
        shot.scene.lights = {{.kind = tables::LightKind::point,
                              .intensity = 100.0F,
                              .position_m = math::Vec3(0.0F, 0.0F, distance_m)}};
        const float expected = 0.5F / math::pi * 100.0F / (distance_m * distance_m);
        EXPECT_NEAR(diffuse_radiance(harness, shot, 0.5F), expected, expected * albedo_share)
            << distance_m;
    }
}

TEST(Lights, ALightEndsAtItsRange) {
    Harness harness;
    Shot shot{.scene = scene_of(quad(4.0F)), .brdf = lambert_only()};
    shot.scene.lights = {{.kind = tables::LightKind::point,
                          .intensity = 100.0F,
                          .position_m = math::Vec3(0.0F, 0.0F, 1.0F),
                          .range_m = 0.99F}};
    EXPECT_EQ(diffuse_radiance(harness, shot, 0.5F), 0.0F);
}

TEST(Lights, ASpotIsFullInsideItsInnerConeAndDarkOutsideItsOuterOne) {
    Harness harness;
    Shot shot{.scene = scene_of(quad(4.0F)), .size = {65, 65}, .brdf = lambert_only()};
    scene::Light spot{.kind = tables::LightKind::spot,
                      .intensity = 100.0F,
                      .position_m = math::Vec3(0.0F, 0.0F, 2.0F),
                      .inner_cone_rad = 0.2F,
                      .outer_cone_rad = 0.4F};
    const float expected = 0.5F / math::pi * 25.0F;
    shot.scene.lights = {spot};
    EXPECT_NEAR(diffuse_radiance(harness, shot, 0.5F), expected, expected * albedo_share);
    spot.direction = math::Vec3(std::sin(0.5F), 0.0F, -std::cos(0.5F));
    shot.scene.lights = {spot};
    EXPECT_EQ(diffuse_radiance(harness, shot, 0.5F), 0.0F);
}

// Tiles only leave out what does not reach them: hundreds of lights in lists sum to what each gives
// alone.
TEST(Lights, ManyLightsInTilesSumToWhatEachGivesAlone) {
    Harness harness;
    Shot shot{.scene = scene_of(sphere(32), material(math::Vec3(0.6F), 0.0F, 0.6F)),
              .size = {96, 96}};
    std::vector<scene::Light> lights;
    for (int i = 0; i < 24; ++i) {
        const float a = static_cast<float>(i) * 2.399963F;
        lights.push_back({.kind = tables::LightKind::point,
                          .intensity = 1.0F,
                          .position_m = {1.4F * std::sin(a), -1.2F + 0.1F * static_cast<float>(i),
                                         1.4F * std::cos(a)},
                          .range_m = 0.9F});
    }
    std::vector<float> sum(static_cast<std::size_t>(shot.size.pixels()) * 4, 0.0F);
    for (const scene::Light& light : lights) {
        shot.scene.lights = {light};
        const auto one = harness.draw(shot);
        ASSERT_TRUE(one) << base::to_line(one.error());
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += one->radiance.as<float>()[i];
    }
    shot.scene.lights = lights;
    const auto all = harness.draw(shot);
    ASSERT_TRUE(all);
    for (std::size_t i = 0; i < sum.size(); ++i) {
        if (i % 4 == 3) continue;  // coverage, not light
        ASSERT_NEAR(all->radiance.as<float>()[i], sum[i], 1e-4F + 1e-4F * sum[i]) << i;
    }
}

}  // namespace
}  // namespace facet::test
