// The glTF importer on sound files: geometry, indices, attributes, meshes as they are completed.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "gltf_fixture.h"

namespace facet::test {
namespace {

using math::Vec2;
using math::Vec3;
using math::Vec4;

/// The one mesh of a document that must load.
scene::Mesh only_mesh(const Document& d) {
    auto loaded = load_document(d);
    EXPECT_TRUE(loaded.has_value()) << base::to_line(loaded.error());
    if (!loaded || loaded->scene.meshes.size() != 1) return {};
    return std::move(loaded->scene.meshes[0]);
}

Vec3 face_normal(const scene::Mesh& mesh, std::size_t triangle = 0) {
    const auto at = [&](std::size_t i) { return mesh.positions_m[mesh.indices[triangle * 3 + i]]; };
    return math::normalize(math::cross(at(1) - at(0), at(2) - at(0)));
}

TEST(GltfMesh, a_triangle_loads_from_text_and_from_glb_alike) {
    const Document d = triangle();
    for (const std::string& file : {d.text(), d.glb()}) {
        const auto loaded = load_text(file);
        ASSERT_TRUE(loaded) << base::to_line(loaded.error());
        ASSERT_EQ(loaded->scene.instances.size(), 1U);
        EXPECT_EQ(loaded->scene.triangle_count(), 1U);
        EXPECT_EQ(loaded->scene.instances[0].node, "Node");
        EXPECT_EQ(loaded->scene.instances[0].object_id, 1U);
        EXPECT_EQ(loaded->scene.bounds_m().high, Vec3(1, 1, 0));
        EXPECT_TRUE(loaded->warnings.empty());
    }
}

TEST(GltfMesh, missing_normals_become_those_of_the_faces) {
    const scene::Mesh mesh = only_mesh(triangle());
    ASSERT_EQ(mesh.normals.size(), 3U);
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
}

TEST(GltfMesh, indices_of_every_type_give_the_same_triangle) {
    const auto with_indices = [](int component, std::size_t (*add)(Document&, int)) {
        Document d = triangle();
        primitive(d)["indices"] = add(d, component);
        return only_mesh(d).indices;
    };
    const std::vector<std::uint32_t> expected{0, 1, 2};
    EXPECT_EQ(with_indices(5121,
                           [](Document& d, int c) {
                               return d.accessor<std::uint8_t>("SCALAR", c, 3, {0, 1, 2});
                           }),
              expected);
    EXPECT_EQ(with_indices(5123,
                           [](Document& d, int c) {
                               return d.accessor<std::uint16_t>("SCALAR", c, 3, {0, 1, 2});
                           }),
              expected);
    EXPECT_EQ(with_indices(5125,
                           [](Document& d, int c) {
                               return d.accessor<std::uint32_t>("SCALAR", c, 3, {0, 1, 2});
                           }),
              expected);
    Document plain = triangle();
    primitive(plain).erase("indices");
    EXPECT_EQ(only_mesh(plain).indices, expected);
}

TEST(GltfMesh, strips_and_fans_keep_every_triangle_facing_the_same_way) {
    for (const int mode : {5, 6}) {
        Document d = triangle();
        // A strip zigzags, a fan goes round; both are a unit square here.
        const std::vector<float> strip{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
        const std::vector<float> fan{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
        primitive(d)["attributes"]["POSITION"] = d.positions(mode == 5 ? strip : fan);
        primitive(d)["mode"] = mode;
        primitive(d).erase("indices");
        const scene::Mesh mesh = only_mesh(d);
        ASSERT_EQ(mesh.indices.size(), 6U) << mode;
        EXPECT_EQ(face_normal(mesh, 0), Vec3(0, 0, 1)) << mode;
        EXPECT_EQ(face_normal(mesh, 1), Vec3(0, 0, 1)) << mode;
    }
}

TEST(GltfMesh, interleaved_attributes_are_taken_apart) {
    Document d;
    const std::vector<float> mixed{0, 0, 0, 0.25F, 0.5F, 1, 0, 0, 0.75F, 1, 0, 1, 0, 0, 0};
    const std::size_t view =
        d.view({reinterpret_cast<const char*>(mixed.data()), mixed.size() * 4});
    d.json["bufferViews"][view]["byteStride"] = 20;
    d.json["accessors"] = {{{"bufferView", view},
                            {"componentType", 5126},
                            {"count", 3},
                            {"type", "VEC3"},
                            {"min", {0, 0, 0}},
                            {"max", {1, 1, 0}}},
                           {{"bufferView", view},
                            {"byteOffset", 12},
                            {"componentType", 5126},
                            {"count", 3},
                            {"type", "VEC2"}}};
    d.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}}}}}};
    d.json["nodes"] = {{{"mesh", 0}}};
    const scene::Mesh mesh = only_mesh(d);
    ASSERT_EQ(mesh.uv0.size(), 3U);
    EXPECT_EQ(mesh.positions_m[1], Vec3(1, 0, 0));
    EXPECT_EQ(mesh.uv0[1], Vec2(0.75F, 1));
}

TEST(GltfMesh, sparse_values_replace_elements_and_zeros_stand_in_for_no_view) {
    Document d;
    const std::size_t indices = d.view(std::string("\1\0\2\0", 4));
    const std::vector<float> replaced{2, 0, 0, 0, 3, 0};
    const std::size_t values = d.view({reinterpret_cast<const char*>(replaced.data()), 24});
    d.json["accessors"] = {{{"componentType", 5126},
                            {"count", 3},
                            {"type", "VEC3"},
                            {"min", {0, 0, 0}},
                            {"max", {2, 3, 0}},
                            {"sparse",
                             {{"count", 2},
                              {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                              {"values", {{"bufferView", values}}}}}}};
    d.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}};
    d.json["nodes"] = {{{"mesh", 0}}};
    const scene::Mesh mesh = only_mesh(d);
    ASSERT_EQ(mesh.positions_m.size(), 3U);
    EXPECT_EQ(mesh.positions_m[0], Vec3(0));
    EXPECT_EQ(mesh.positions_m[1], Vec3(2, 0, 0));
    EXPECT_EQ(mesh.positions_m[2], Vec3(0, 3, 0));
}

TEST(GltfMesh, quantised_positions_keep_their_whole_numbers_and_normalised_ones_are_scaled) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    d.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const auto position =
        d.accessor<std::int16_t>("VEC3", 5122, 3, {0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0});
    d.json["accessors"][position]["min"] = {0, 0, 0};
    d.json["accessors"][position]["max"] = {100, 100, 0};
    d.json["bufferViews"].back()["byteStride"] = 8;
    const auto uv = d.accessor<std::uint16_t>("VEC2", 5123, 3, {0, 0, 65535, 0, 0, 65535});
    d.json["accessors"][uv]["normalized"] = true;
    const auto normal =
        d.accessor<std::int8_t>("VEC3", 5120, 3, {0, 0, 127, 0, 0, 0, -127, 0, 0, -128, 0, 0});
    d.json["accessors"][normal]["normalized"] = true;
    d.json["bufferViews"].back()["byteStride"] = 4;
    primitive(d)["attributes"] = {{"POSITION", position}, {"TEXCOORD_0", uv}, {"NORMAL", normal}};
    const scene::Mesh mesh = only_mesh(d);
    ASSERT_EQ(mesh.normals.size(), 3U);
    EXPECT_EQ(mesh.positions_m[1], Vec3(100, 0, 0));
    EXPECT_EQ(mesh.uv0[1], Vec2(1, 0));
    EXPECT_EQ(mesh.normals[1], Vec3(0, 0, -1));
    EXPECT_EQ(mesh.normals[2], Vec3(0, -1, 0));
}

TEST(GltfMesh, vertex_colors_of_three_parts_are_opaque_and_of_bytes_are_scaled) {
    Document d = triangle();
    const auto color =
        d.accessor<std::uint8_t>("VEC3", 5121, 3, {255, 0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0});
    d.json["accessors"][color]["normalized"] = true;
    d.json["bufferViews"].back()["byteStride"] = 4;
    primitive(d)["attributes"]["COLOR_0"] = color;
    const scene::Mesh mesh = only_mesh(d);
    ASSERT_EQ(mesh.colors.size(), 3U);
    EXPECT_EQ(mesh.colors[0], Vec4(1, 0, 0, 1));
    EXPECT_EQ(mesh.colors[2], Vec4(0, 0, 1, 1));
}

TEST(GltfMesh, both_uv_sets_are_read) {
    Document d = triangle();
    primitive(d)["attributes"]["TEXCOORD_0"] = d.floats("VEC2", 2, {0, 0, 1, 0, 0, 1});
    primitive(d)["attributes"]["TEXCOORD_1"] = d.floats("VEC2", 2, {5, 5, 6, 5, 5, 6});
    const scene::Mesh mesh = only_mesh(d);
    ASSERT_EQ(mesh.uv1.size(), 3U);
    EXPECT_EQ(mesh.uv0[1], Vec2(1, 0));
    EXPECT_EQ(mesh.uv1[1], Vec2(6, 5));
}

TEST(GltfMesh, triangles_without_area_are_dropped_and_counted) {
    Document d = triangle();
    primitive(d)["indices"] = d.accessor<std::uint16_t>("SCALAR", 5123, 6, {0, 1, 1, 0, 1, 2});
    const auto loaded = load_document(d);
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded->scene.triangle_count(), 1U);
    ASSERT_EQ(loaded->warnings.size(), 1U);
    EXPECT_EQ(loaded->warnings[0].found, "1");
}

TEST(GltfMesh, a_count_that_is_no_multiple_of_three_loses_its_tail_with_a_warning) {
    Document d = triangle();
    primitive(d)["indices"] = d.accessor<std::uint16_t>("SCALAR", 5123, 5, {0, 1, 2, 0, 1});
    const auto loaded = load_document(d);
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded->scene.triangle_count(), 1U);
    EXPECT_EQ(loaded->warnings.size(), 1U);
}

TEST(GltfMesh, normals_that_are_zero_or_no_numbers_come_from_the_faces) {
    Document d = triangle();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    primitive(d)["attributes"]["NORMAL"] = d.floats("VEC3", 3, {0, 0, 0, nan, 1, 0, 0, 0, 2});
    const auto loaded = load_document(d);
    ASSERT_TRUE(loaded);
    for (const Vec3& normal : loaded->scene.meshes[0].normals) EXPECT_EQ(normal, Vec3(0, 0, 1));
    ASSERT_EQ(loaded->warnings.size(), 1U);
    EXPECT_EQ(loaded->warnings[0].found, "2 vertices");
}

TEST(GltfMesh, texture_coordinates_that_are_no_numbers_become_zero_with_one_warning) {
    Document d = triangle();
    const float infinite = std::numeric_limits<float>::infinity();
    primitive(d)["attributes"]["TEXCOORD_0"] = d.floats("VEC2", 2, {0, 0, infinite, 0, 0, 1});
    const auto loaded = load_document(d);
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded->scene.meshes[0].uv0[1], Vec2(0));
    EXPECT_EQ(loaded->warnings.size(), 1U);
}

TEST(GltfMesh, morph_targets_move_by_the_default_weights_and_a_node_may_choose_others) {
    Document d = triangle();
    primitive(d)["targets"] = {{{"POSITION", d.positions({0, 0, 2, 0, 0, 2, 0, 0, 2})}}};
    d.json["meshes"][0]["weights"] = {0.5};
    d.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"weights", {1.0}}}};
    d.json["scenes"][0]["nodes"] = {0, 1};
    const auto loaded = load_document(d);
    ASSERT_TRUE(loaded) << base::to_line(loaded.error());
    ASSERT_EQ(loaded->scene.meshes.size(), 2U);
    EXPECT_EQ(loaded->scene.meshes[0].positions_m[0].z, 1.0F);
    EXPECT_EQ(loaded->scene.meshes[1].positions_m[0].z, 2.0F);
}

TEST(GltfMesh, a_skinned_mesh_stands_where_its_joints_are_and_not_its_node) {
    Document d = triangle();
    primitive(d)["attributes"]["JOINTS_0"] =
        d.accessor<std::uint8_t>("VEC4", 5121, 3, {0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
    primitive(d)["attributes"]["WEIGHTS_0"] =
        d.floats("VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0});
    d.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}},
                       {{"translation", {0, 10, 0}}, {"children", {2}}},
                       {{"translation", {0, 0, 4}}}};
    d.json["scenes"][0]["nodes"] = {0, 1};
    // The second joint's bind matrix undoes the first joint's share.
    d.json["skins"] = {{{"joints", {1, 2}},
                        {"inverseBindMatrices",
                         d.floats("MAT4", 16, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,   0, 0, 1, 1,
                                               0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -10, 0, 1})}}};
    const auto loaded = load_document(d);
    ASSERT_TRUE(loaded) << base::to_line(loaded.error());
    const scene::Mesh& mesh = loaded->scene.meshes[0];
    EXPECT_EQ(mesh.positions_m[0], Vec3(0, 10, 0));
    EXPECT_EQ(mesh.positions_m[1], Vec3(1, 0, 4));
    EXPECT_EQ(mesh.positions_m[2], Vec3(0, 6, 2));
    EXPECT_EQ(loaded->scene.instances[0].world_from_object, math::Mat4(1.0F));
}

TEST(GltfMesh, accessors_with_numbers_written_as_floats_are_taken) {
    std::string text = triangle().text();
    text.replace(text.find("\"count\":3"), 9, "\"count\":3.0");
    EXPECT_TRUE(load_text(text).has_value());
}

}  // namespace
}  // namespace facet::test
