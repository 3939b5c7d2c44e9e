// Shapes of lights that are seen: where they are, and what they leave alone.
// SPDX-License-Identifier: MIT
#include "scene/light_shapes.h"

#include "scene/camera_spec.h"
#include "scene/light_spec.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace facet::scene {
namespace {

constexpr const char* shapes[] = {"rect:width=2,height=0.5", "disk:radius=0.7", "sphere:radius=0.7",
                                  "tube:width=2,radius=0.3"};

Light visible(const std::string& spec) {
    const auto light = parse_light(spec + ",position=1 2 3,nit=7,visible=on");
    EXPECT_TRUE(light) << (light ? "" : base::to_line(light.error()));
    return light.value_or(Light{});
}
Scene scene_with(std::vector<Light> lights) {
    Scene scene = test::scene_of(test::quad(2.0F));
    scene.lights = std::move(lights);
    place_light_shapes(scene);
    return scene;
}

/// Calls with the corners of each triangle of an instance in the world.
template <class Each>
void for_each_triangle(const Scene& scene, const Instance& instance, const Each& each) {
    const Mesh& mesh = scene.meshes[instance.mesh.index];
    const auto corner = [&](std::size_t i) {
        return Vec3(instance.world_from_object * Vec4(mesh.positions_m[mesh.indices[i]], 1.0F));
    };
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        each(corner(i), corner(i + 1), corner(i + 2));
}

// Inscribed in the true surface: of a circle's area, a polygon of n corners has
// sin(2 pi / n) / (2 pi / n), 1.6e-3 less for 64; a ball twice that.
TEST(LightShapes, HaveTheAreaOfTheLightAndFaceOutwards) {
    for (const char* spec : shapes) {
        const Light light = visible(spec);
        const Scene scene = scene_with({light});
        ASSERT_GE(scene.instances.size(), 2U);
        const Instance& bright = scene.instances[1];
        EXPECT_EQ(scene.material_of(bright).values.emissive, Vec3(7.0F));
        float area = 0.0F;
        Vec3 sum(0.0F);
        const bool is_flat =
            light.kind == tables::LightKind::rect || light.kind == tables::LightKind::disk;
        const LightAxes axes = axes_of(light);
        for_each_triangle(scene, bright, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
            const Vec3 twice = math::cross(b - a, c - a);
            area += 0.5F * math::length(twice);
            sum += 0.5F * twice;
            Vec3 out = (a + b + c) / 3.0F - light.position_m;
            if (light.kind == tables::LightKind::tube) out -= axes.x * math::dot(out, axes.x);
            EXPECT_GT(math::dot(twice, is_flat ? axes.z : out), 0.0F) << spec;
        });
        EXPECT_LE(area, area_m2(light) * (1.0F + 1e-5F)) << spec;
        EXPECT_GE(area, area_m2(light) * (1.0F - 5e-3F)) << spec;
        if (is_flat) continue;
        EXPECT_LT(math::length(sum), 1e-4F) << spec << ": its sides do not close";
    }
}

TEST(LightShapes, AreBlackWhereTheLightDoesNotShine) {
    for (const char* spec : shapes) {
        const Scene scene = scene_with({visible(spec)});
        const bool is_ball = scene.lights[0].kind == tables::LightKind::sphere;
        ASSERT_EQ(scene.instances.size(), is_ball ? 2U : 3U) << spec;
        if (is_ball) continue;
        const Material& dark = scene.material_of(scene.instances[2]);
        EXPECT_TRUE(dark.unlit);
        EXPECT_EQ(dark.values.emissive + dark.values.base_color, Vec3(0.0F)) << spec;
        Vec3 sum(0.0F);
        for_each_triangle(scene, scene.instances[2],
                          [&](const Vec3& a, const Vec3& b, const Vec3& c) {
                              sum += 0.5F * math::cross(b - a, c - a);
                          });
        // A back faces away from where the light shines; two ends face away from each other.
        const float along = math::dot(sum, scene.lights[0].direction);
        const bool is_tube = scene.lights[0].kind == tables::LightKind::tube;
        const float expected = is_tube ? 0.0F : -area_m2(scene.lights[0]);
        EXPECT_NEAR(along, expected, 5e-3F * area_m2(scene.lights[0])) << spec;
    }
}

TEST(LightShapes, OfLightsThatAreNotVisibleAreNotThere) {
    Scene scene = scene_with({visible(shapes[0]), visible(shapes[2])});
    EXPECT_EQ(model_counts(scene).instances, 1U);
    EXPECT_EQ(scene.instances.size(), 4U);
    EXPECT_EQ(scene.instances[3].light, 1U);
    for (Light& light : scene.lights) light.is_visible = false;
    place_light_shapes(scene);
    EXPECT_EQ(scene.instances.size(), 1U);
    EXPECT_EQ(scene.meshes.size(), 1U);
    EXPECT_EQ(scene.materials.size(), 1U);
}

TEST(LightShapes, PlacedAgainAreTheSame) {
    Scene scene = scene_with({visible(shapes[3])});
    const std::size_t materials = scene.materials.size();
    place_light_shapes(scene);
    EXPECT_EQ(scene.materials.size(), materials);
    EXPECT_EQ(scene.instances.size(), 3U);
    EXPECT_EQ(scene.meshes.size(), 3U);
    EXPECT_EQ(scene.instances[1].object_id, 2U);
}

TEST(LightShapes, MoveNoCameraButItsDepthRangeHoldsThem) {
    Light far = visible("sphere:radius=1");
    far.position_m = {0.0F, 0.0F, -200.0F};
    const Scene without = scene_with({});
    const Scene with = scene_with({far});
    const auto a = resolve_camera(without, "orbit:azimuth=0,elevation=0", 0.0F, {64, 64});
    const auto b = resolve_camera(with, "orbit:azimuth=0,elevation=0", 0.0F, {64, 64});
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->world_from_view, b->world_from_view);
    EXPECT_GT(b->far_m, 201.0F);
    EXPECT_EQ(a->near_m, b->near_m);
    EXPECT_EQ(with.bounds_m().diagonal(), without.bounds_m().diagonal());
}

}  // namespace
}  // namespace facet::scene
