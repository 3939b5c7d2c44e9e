// Which light is the key light, and where an environment's light comes from.
// SPDX-License-Identifier: MIT
#include "scene/key_light.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace facet::test {
namespace {

using math::Vec3;
using math::Vec4;
using tables::LightKind;

scene::Environment environment_of(std::shared_ptr<const image::Image> latlong) {
    return {.name = "test", .latlong = std::move(latlong)};
}

/// Black but for the column `x` of the middle row.
scene::Environment one_spot(std::uint32_t x) {
    auto picture = std::make_shared<image::Image>(math::Extent{64, 33}, 3, image::Sample::f32);
    const auto values = picture->as<float>();
    for (float& value : values) value = 0.0F;
    for (std::size_t c = 0; c < 3; ++c) values[(std::size_t{16} * 64 + x) * 3 + c] = 10.0F;
    return environment_of(picture);
}

scene::Scene lit_scene() {
    scene::Scene scene = scene_of(quad(2.0F));
    scene.lights = {
        {.kind = LightKind::directional, .intensity = 3.0F},
        {.kind = LightKind::point, .intensity = 20.0F, .position_m = {0.0F, 0.0F, 2.0F}},
        {.kind = LightKind::spot,
         .intensity = 1000.0F,
         .position_m = {0.0F, 0.0F, 2.0F},
         .direction = {0.0F, 0.0F, 1.0F}}};
    return scene;
}

TEST(KeyLight, IsTheOneThatLightsTheMiddleMost) {
    // 3 lux; 20 cd / 4 m2 = 5 lux; and a spot that shines away.
    const auto key = scene::key_light(
        {.scene = lit_scene(), .environment = environment_of(constant_environment(Vec3(1.0F)))});
    EXPECT_EQ(key.place, Vec4(0.0F, 0.0F, 2.0F, 1.0F));
    EXPECT_EQ(key.direction_from({0.0F, 0.0F, 0.0F}), Vec3(0.0F, 0.0F, 1.0F));
}

TEST(KeyLight, IsTheUsersFirstWhereThereIsOne) {
    const auto key =
        scene::key_light({.scene = lit_scene(),
                          .environment = environment_of(constant_environment(Vec3(1.0F))),
                          .named = 0});
    EXPECT_EQ(key.place, Vec4(0.0F, 0.0F, 1.0F, 0.0F)) << "against the light's direction";
}

TEST(KeyLight, IsWhereTheEnvironmentShinesFromWithoutALight) {
    const scene::Scene scene = scene_of(quad(2.0F));
    // Column 48.5 of 64 is a quarter turn to the right of -z: towards +x.
    const scene::Environment right = one_spot(48);
    const Vec3 plain(scene::key_light({.scene = scene, .environment = right}).place);
    EXPECT_NEAR(plain.x, 1.0F, 2e-3F);
    EXPECT_NEAR(plain.y, 0.0F, 1e-6F) << "the middle row";
    // A quarter turn counter-clockwise seen from above takes +x to -z.
    const Vec3 turned(
        scene::key_light({.scene = scene, .environment = right, .env_rotation_deg = 90.0F}).place);
    EXPECT_NEAR(turned.z, -1.0F, 2e-3F);
}

TEST(KeyLight, IsOverheadWhereLightComesFromEverywhereAlike) {
    const auto everywhere = environment_of(constant_environment(Vec3(2.0F)));
    EXPECT_EQ(scene::dominant_direction(everywhere, 30.0F), Vec3(0.0F, 1.0F, 0.0F));
}

}  // namespace
}  // namespace facet::test
