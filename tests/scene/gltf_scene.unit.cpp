// The glTF importer on sound files: nodes, scenes, cameras, lights, names.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "gltf_fixture.h"

namespace facet::test {
namespace {

using math::Vec3;
using math::Vec4;

TEST(GltfNodes, translation_rotation_and_scale_act_in_that_order_down_the_tree) {
    Document d = triangle();
    const float half = std::sqrt(0.5F);
    d.json["nodes"] = {{{"translation", {10, 0, 0}}, {"children", {1}}},
                       {{"mesh", 0}, {"rotation", {0, 0, half, half}}, {"scale", {2, 1, 1}}}};
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.scene.instances.size(), 1U);
    const Vec4 moved = loaded.scene.instances[0].world_from_object * Vec4(1, 0, 0, 1);
    EXPECT_NEAR(moved.x, 10, 1e-5);  // doubled along x, then turned to y
    EXPECT_NEAR(moved.y, 2, 1e-5);
}

TEST(GltfNodes, a_matrix_is_read_by_columns) {
    Document d = triangle();
    d.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1};
    const scene::Loaded loaded = loaded_or_fail(d);
    EXPECT_EQ(Vec3(loaded.scene.instances[0].world_from_object[3]), Vec3(3, 4, 5));
}

TEST(GltfNodes, a_mirroring_node_still_shows_the_front_counter_clockwise) {
    Document d = triangle();
    d.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"scale", {-1, 1, 1}}}};
    d.json["scenes"][0]["nodes"] = {0, 1};
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.scene.instances.size(), 2U);
    for (const scene::Instance& instance : loaded.scene.instances) {
        const scene::Mesh& mesh = loaded.scene.meshes[instance.mesh.index];
        const auto at = [&](std::size_t i) {
            return Vec3(instance.world_from_object * Vec4(mesh.positions_m[mesh.indices[i]], 1));
        };
        EXPECT_GT(math::cross(at(1) - at(0), at(2) - at(0)).z, 0) << instance.object_id;
    }
}

TEST(GltfNodes, nodes_that_share_a_mesh_share_it_in_the_scene_too) {
    Document d = triangle();
    d.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {1, 0, 0}}}};
    d.json["scenes"][0]["nodes"] = {0, 1};
    const scene::Loaded loaded = loaded_or_fail(d);
    EXPECT_EQ(loaded.scene.meshes.size(), 1U);
    EXPECT_EQ(loaded.scene.instances.size(), 2U);
    EXPECT_EQ(loaded.scene.triangle_count(), 2U);
}

TEST(GltfNodes, a_mesh_scaled_to_nothing_is_dropped_with_a_warning) {
    Document d = triangle();
    d.json["nodes"][0]["scale"] = {1, 0, 1};
    const scene::Loaded loaded = loaded_or_fail(d);
    EXPECT_TRUE(loaded.scene.instances.empty());
    EXPECT_FALSE(loaded.warnings.empty());
}

TEST(GltfNodes, the_scene_shown_can_be_chosen_and_the_default_is_the_files) {
    Document d = triangle();
    d.json["nodes"] = {{{"mesh", 0}, {"name", "first"}}, {{"mesh", 0}, {"name", "second"}}};
    d.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}, {"name", "Two"}}};
    d.json["scene"] = 1;
    EXPECT_EQ(loaded_or_fail(d).scene.instances[0].node, "second");
    EXPECT_EQ(loaded_or_fail(d).scene.name, "Two");
    EXPECT_EQ(loaded_or_fail(d, {.scene_index = 0}).scene.instances[0].node, "first");
    const auto beyond = load_document(d, {.scene_index = 2});
    ASSERT_FALSE(beyond);
    EXPECT_EQ(beyond.error().code, base::ErrorCode::usage);
}

TEST(GltfNodes, a_file_without_scenes_shows_all_its_roots_with_a_warning) {
    Document d = triangle();
    d.json.erase("scenes");
    d.json.erase("scene");
    const scene::Loaded loaded = loaded_or_fail(d);
    EXPECT_EQ(loaded.scene.instances.size(), 1U);
    EXPECT_EQ(loaded.warnings.size(), 1U);
}

TEST(GltfNodes, invisible_nodes_hide_what_is_below_them) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_node_visibility"};
    d.json["nodes"] = {
        {{"children", {1}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}},
        {{"mesh", 0}}};
    EXPECT_TRUE(loaded_or_fail(d).scene.instances.empty());
}

TEST(GltfNodes, instances_of_the_gpu_instancing_extension_are_placed_one_by_one) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    const auto moves = d.floats("VEC3", 3, {0, 0, 0, 5, 0, 0, 10, 0, 0});
    d.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
        moves;
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.scene.instances.size(), 3U);
    EXPECT_EQ(loaded.scene.meshes.size(), 1U);
    EXPECT_EQ(loaded.scene.instances[2].world_from_object[3].x, 10);
}

TEST(GltfCameras, perspective_and_orthographic_ones_are_placed_without_scale) {
    Document d = triangle();
    d.json["cameras"] = {
        {{"type", "perspective"},
         {"name", "Eye"},
         {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}},
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 4}, {"ymag", 3}, {"znear", 0.5}, {"zfar", 9}}}}};
    d.json["nodes"] = {{{"mesh", 0}},
                       {{"camera", 0}, {"translation", {1, 2, 3}}, {"scale", {5, 5, 5}}},
                       {{"camera", 1}, {"name", "Top"}, {"scale", {-1, 1, 1}}}};
    d.json["scenes"][0]["nodes"] = {0, 1, 2};
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.scene.cameras.size(), 2U);
    const scene::Camera& eye = loaded.scene.cameras[0];
    EXPECT_EQ(eye.name, "Eye");
    EXPECT_FLOAT_EQ(eye.yfov_rad, 0.7F);
    EXPECT_EQ(eye.far_m, 0.0F);
    EXPECT_EQ(eye.world_from_view, glm::translate(math::Mat4(1.0F), Vec3(1, 2, 3)));
    const scene::Camera& top = loaded.scene.cameras[1];
    EXPECT_EQ(top.name, "Top");
    EXPECT_EQ(top.projection, scene::Projection::orthographic);
    EXPECT_EQ(top.ymag_m, 3.0F);
    EXPECT_GT(glm::determinant(math::Mat3(top.world_from_view)), 0);
}

TEST(GltfLights, punctual_lights_have_the_units_place_and_direction_of_their_nodes) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_lights_punctual"};
    d.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"intensity", 1000}, {"color", {1, 0.5, 0}}},
        {{"type", "spot"}, {"spot", {{"outerConeAngle", 0.5}}}, {"range", 20}, {"name", "Lamp"}}};
    const float half = std::sqrt(0.5F);
    d.json["nodes"] = {
        {{"mesh", 0}},
        {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}},
         {"rotation", {-half, 0, 0, half}}},
        {{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}, {"translation", {0, 4, 0}}}};
    d.json["scenes"][0]["nodes"] = {0, 1, 2};
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.scene.lights.size(), 2U);
    const scene::Light& sun = loaded.scene.lights[0];
    EXPECT_EQ(sun.kind, tables::LightKind::directional);
    EXPECT_EQ(sun.intensity, 1000.0F);
    EXPECT_EQ(sun.color, Vec3(1, 0.5F, 0));
    EXPECT_NEAR(sun.direction.y, -1, 1e-5);  // -z turned down
    const scene::Light& lamp = loaded.scene.lights[1];
    EXPECT_EQ(lamp.kind, tables::LightKind::spot);
    EXPECT_EQ(lamp.name, "Lamp");
    EXPECT_EQ(lamp.position_m, Vec3(0, 4, 0));
    EXPECT_EQ(lamp.range_m, 20.0F);
    EXPECT_EQ(lamp.inner_cone_rad, 0.0F);
    EXPECT_EQ(lamp.outer_cone_rad, 0.5F);
}

TEST(GltfVariants, give_primitives_their_own_materials_and_others_keep_theirs) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_materials_variants"};
    d.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "red"}},
                                                                  {{"name", "blue"}}};
    d.json["materials"] = {{{"name", "plain"}}, {{"name", "paint"}}};
    primitive(d)["material"] = 0;
    primitive(d)["extensions"]["KHR_materials_variants"]["mappings"] = {
        {{"material", 1}, {"variants", {1}}}};
    const auto worn = [&](const std::string& variant) {
        const scene::Scene scene = loaded_or_fail(d, {.variant = variant}).scene;
        return scene.materials[scene.meshes.at(0).material.index].name;
    };
    EXPECT_EQ(worn(""), "plain");
    EXPECT_EQ(worn("red"), "plain");
    EXPECT_EQ(worn("blue"), "paint");
    const auto unknown = load_document(d, {.variant = "green"});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, base::ErrorCode::usage);
    EXPECT_NE(unknown.error().remedy.find("red, blue"), std::string::npos);
}

TEST(GltfNames, clips_and_variants_are_listed) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_materials_variants"};
    d.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "red"}},
                                                                  {{"name", "blue"}}};
    const auto times = d.floats("SCALAR", 1, {0, 1});
    d.json["accessors"][times]["min"] = {0};
    d.json["accessors"][times]["max"] = {1};
    const auto moves = d.floats("VEC3", 3, {0, 0, 0, 1, 0, 0});
    d.json["animations"] = {
        {{"name", "Walk"},
         {"samplers", {{{"input", times}, {"output", moves}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
    const scene::Loaded loaded = loaded_or_fail(d);
    EXPECT_EQ(loaded.scene.variants, (std::vector<std::string>{"red", "blue"}));
    EXPECT_EQ(loaded.scene.animations, (std::vector<std::string>{"Walk"}));
}

}  // namespace
}  // namespace facet::test
