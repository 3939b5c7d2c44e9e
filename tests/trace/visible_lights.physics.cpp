// Lights that are seen themselves: what they show, what they hide, and that their light is counted
// once. SPDX-License-Identifier: MIT
#include "scene/light_shapes.h"
#include "support/trace_harness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace facet::test {
namespace {

using math::Vec3;
using math::Vec4;
using scene::Light;
using tables::LightKind;

constexpr LightKind sized_kinds[] = {LightKind::rect, LightKind::disk, LightKind::sphere,
                                     LightKind::tube};

/// Shines along -z onto what lies in the plane z = 0.
Light light_above(LightKind kind, float height_m) {
    return {.kind = kind,
            .intensity = 3.0F,
            .position_m = {0.0F, 0.0F, height_m},
            .direction = {0.0F, 0.0F, -1.0F},
            .radius_m = 0.2F,
            .width_m = 0.8F,
            .height_m = 0.5F,
            .is_visible = true};
}

/// A square floor of 2 m in the plane z = 0, seen from straight above by a camera below the lights.
TraceShot floor_under(std::vector<Light> lights, const scene::Material& material) {
    TraceShot shot{.scene = scene_of(quad(2.0F), material)};
    shot.scene.lights = std::move(lights);
    scene::place_light_shapes(shot.scene);
    shot.camera = camera_on_z(0.5F, 1.0F);
    shot.settings.samples = 64;
    return shot;
}

/// A picture of the light alone, from `eye_z_m` on its axis.
Vec4 seen_from(const Light& light, float eye_z_m) {
    TraceShot shot;
    shot.scene.lights = {light};
    scene::place_light_shapes(shot.scene);
    shot.camera = camera_on_z(eye_z_m, 1.0F);
    if (eye_z_m < light.position_m.z)
        shot.camera.world_from_view = math::Mat4(Vec4(-1, 0, 0, 0), Vec4(0, 1, 0, 0),
                                                 Vec4(0, 0, -1, 0), Vec4(0, 0, eye_z_m, 1));
    return mean(traced(shot).radiance);
}

// The window is 2 m x 2 m: coverage is a quarter of the silhouette in square metres. Polygons of 64
// corners have 1.6e-3 less than the circle; 64 x 64 x 16 points of a net miss an edge by less than
// 1e-3.
TEST(VisibleLight, ShowsItsRadianceInItsOwnOutline) {
    const float round = math::pi * 0.2F * 0.2F;
    const float outlines_m2[] = {0.8F * 0.5F, round, round, 0.8F * 0.4F};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec4 seen = seen_from(light_above(sized_kinds[i], 1.0F), 0.0F);
        EXPECT_NEAR(seen.w, outlines_m2[i] / 4.0F, 1e-3F) << i;
        EXPECT_NEAR(seen.x, 3.0F * seen.w, 1e-5F) << i;
    }
}

TEST(VisibleLight, IsBlackFromBehindWhereItIsOneSided) {
    for (const LightKind kind : {LightKind::rect, LightKind::disk}) {
        const Vec4 seen = seen_from(light_above(kind, 1.0F), 2.0F);
        EXPECT_GT(seen.w, 0.02F);
        EXPECT_EQ(seen.x, 0.0F);
    }
}

// White and rough, so that paths find the light and draw it both. Nothing else is there: what is
// counted twice, or what a light hides of itself, shows as another mean. The two estimates share
// their sample points; their standard errors are below 1e-3.
TEST(VisibleLight, LightsAFloorAsItDoesUnseen) {
    for (const LightKind kind : sized_kinds)
        for (const float roughness : {0.3F, 1.0F}) {
            Light light = light_above(kind, 0.8F);
            const scene::Material white = material(Vec3(1.0F), 0.5F, roughness);
            const float seen = mean(traced(floor_under({light}, white)).radiance).x;
            light.is_visible = false;
            const float unseen = mean(traced(floor_under({light}, white)).radiance).x;
            EXPECT_NEAR(seen / unseen, 1.0F, 3e-3F) << static_cast<int>(kind) << ' ' << roughness;
        }
}

// A ball over a plane: E = pi L (r / d)^2 below its middle, however near (a sphere's irradiance is
// that of a point; Lagarde & de Rousiers 2014, Section 4.7.2).
TEST(VisibleLight, GivesTheIrradianceOfTheClosedForm) {
    TraceShot shot =
        floor_under({light_above(LightKind::sphere, 1.0F)}, material(Vec3(0.5F), 0.0F, 1.0F));
    shot.scene.materials[0].values.specular = 0.0F;
    shot.camera = camera_on_z(0.5F, 0.005F);
    const float expected = 0.5F / math::pi * math::pi * 3.0F * 0.04F;
    EXPECT_NEAR(mean(traced(shot).radiance).x, expected, 0.01F * expected);
}

TEST(VisibleLight, IsAsBrightInAMirrorAsItIs) {
    for (const LightKind kind : sized_kinds) {
        TraceShot shot = floor_under({light_above(kind, 0.8F)}, material(Vec3(1.0F), 1.0F, 0.0F));
        shot.settings.samples = 4;
        const Vec4 middle = pixel(traced(shot).radiance, 32, 32);
        EXPECT_NEAR(middle.x, 3.0F, 1e-3F) << static_cast<int>(kind);
    }
}

// In a mirror it hides a brighter light behind it, as nothing hides behind one that is not seen.
TEST(VisibleLight, HidesWhatIsBehindIt) {
    Light front = light_above(LightKind::disk, 0.8F);
    Light behind = light_above(LightKind::disk, 1.6F);
    behind.intensity = 50.0F;
    for (const bool is_visible : {true, false}) {
        front.is_visible = is_visible;
        TraceShot shot = floor_under({front, behind}, material(Vec3(1.0F), 1.0F, 0.0F));
        shot.settings.samples = 4;
        EXPECT_NEAR(pixel(traced(shot).radiance, 32, 32).x, is_visible ? 3.0F : 53.0F, 1e-2F);
    }
}

// A point straight above, as far above the light as that is above the floor: the shadow is twice as
// large as the light.
TEST(VisibleLight, CastsTheShadowOfAnotherLight) {
    const Light point{.kind = LightKind::point, .intensity = 10.0F, .position_m = {0, 0, 1.6F}};
    for (const LightKind kind : sized_kinds) {
        Light shape = light_above(kind, 0.8F);
        shape.intensity = 0.0F;
        const auto lit_at = [&](bool is_visible, std::uint32_t y) {
            shape.is_visible = is_visible;
            TraceShot shot = floor_under({point, shape}, material(Vec3(0.5F), 0.0F, 1.0F));
            shot.settings.samples = 16;
            return pixel(traced(shot).radiance, 32, y).x;
        };
        EXPECT_EQ(lit_at(true, 32), 0.0F) << static_cast<int>(kind);
        EXPECT_GT(lit_at(false, 32), 0.1F);
        EXPECT_NEAR(lit_at(true, 1), lit_at(false, 1), 1e-6F) << static_cast<int>(kind);
    }
}

}  // namespace
}  // namespace facet::test
