// Points and lines: bodies of the documented width, closed, outside out, unlit where they have no
// normals.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "animation_fixture.h"

namespace facet::test {
namespace {

using math::Vec3;

/// The triangle's three vertices drawn in another mode.
Document thin(int mode) {
    Document d = triangle();
    primitive(d)["mode"] = mode;
    return d;
}

/// Six times the volume within; positive where triangles are counter-clockwise seen from outside.
double volume6(const scene::Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return mesh.positions_m[mesh.indices[i + k]]; };
        sum += static_cast<double>(math::dot(at(0), math::cross(at(1), at(2))));
    }
    return sum;
}

TEST(GltfLines, each_mode_draws_its_own_number_of_bodies) {
    constexpr std::size_t of_point = 8;
    constexpr std::size_t of_line = 16;
    const std::pair<int, std::size_t> modes[] = {
        {0, 3 * of_point}, {1, of_line}, {2, 3 * of_line}, {3, 2 * of_line}};
    for (const auto& [mode, triangles] : modes) {
        const scene::Loaded loaded = loaded_or_fail(thin(mode));
        EXPECT_EQ(loaded.scene.triangle_count(), triangles) << mode;
        // Three vertices are a line and a half.
        EXPECT_EQ(loaded.warnings.size(), mode == 1 ? 1U : 0U) << mode;
    }
}

TEST(GltfLines, widths_are_shares_of_the_scenes_diagonal_whatever_the_nodes_scale) {
    const float diagonal = std::sqrt(2.0F);
    for (const float scale : {1.0F, 1000.0F}) {
        Document d = thin(3);
        d.json["nodes"][0]["scale"] = {scale, scale, scale};
        const scene::Loaded loaded = loaded_or_fail(d);
        const math::Bounds bounds = loaded.scene.bounds_m();
        // The strip lies in the plane z = 0.
        EXPECT_NEAR((bounds.high.z - bounds.low.z) / scale, diagonal / 250.0F, 1e-5F) << scale;
    }
    const math::Bounds points = loaded_or_fail(thin(0)).scene.bounds_m();
    EXPECT_NEAR(points.high.z - points.low.z, diagonal / 120.0F, 1e-5F);
}

TEST(GltfLines, bodies_are_closed_and_their_outside_is_out_even_where_they_are_mirrored) {
    for (const int mode : {0, 1})
        for (const double side : {1.0, -1.0}) {
            Document d = thin(mode);
            d.json["nodes"][0]["scale"] = {side, 1, 1};
            const scene::Loaded loaded = loaded_or_fail(d);
            ASSERT_EQ(loaded.scene.meshes.size(), 1U);
            EXPECT_GT(volume6(loaded.scene.meshes[0]) * side, 0.0) << mode << ' ' << side;
        }
    // An octahedron's volume is 4/3 of its radius' cube.
    const scene::Loaded points = loaded_or_fail(thin(0));
    const double radius = std::sqrt(2.0) / 240.0;
    EXPECT_NEAR(volume6(points.scene.meshes[0]) / (3.0 * 8.0 * radius * radius * radius), 1.0,
                1e-3);
}

TEST(GltfLines, without_normals_the_material_is_unlit_and_with_them_it_is_as_it_was) {
    Document d = thin(3);
    d.json["materials"] = {{{"name", "ink"}}};
    primitive(d)["material"] = 0;
    const scene::Loaded plain = loaded_or_fail(d);
    const scene::Material& unlit = plain.scene.material_of(plain.scene.instances.at(0));
    EXPECT_TRUE(unlit.unlit);
    EXPECT_EQ(unlit.name, "ink");
    EXPECT_FALSE(plain.scene.materials[0].unlit);
    primitive(d)["attributes"]["NORMAL"] = d.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
    const scene::Loaded lit = loaded_or_fail(d);
    EXPECT_FALSE(lit.scene.material_of(lit.scene.instances.at(0)).unlit);
    EXPECT_EQ(lit.scene.meshes.at(0).normals.at(3), Vec3(0, 0, 1));
}

TEST(GltfLines, colors_and_joints_go_with_their_vertices) {
    Document d = thin(1);
    primitive(d)["indices"] = d.accessor<std::uint16_t>("SCALAR", 5123, 2, {0, 2});
    primitive(d)["attributes"]["COLOR_0"] =
        d.floats("VEC4", 4, {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1});
    const scene::Loaded loaded = loaded_or_fail(d);
    ASSERT_EQ(loaded.scene.meshes.size(), 1U);
    const scene::Mesh& mesh = loaded.scene.meshes[0];
    ASSERT_EQ(mesh.colors.size(), 10U);
    EXPECT_EQ(mesh.colors.front(), math::Vec4(1, 0, 0, 1));
    EXPECT_EQ(mesh.colors.back(), math::Vec4(0, 0, 1, 1));
    // Each end hangs on a joint of its own, the second of which is 5 m away.
    primitive(d)["attributes"]["JOINTS_0"] =
        d.accessor<std::uint8_t>("VEC4", 5121, 3, {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0});
    primitive(d)["attributes"]["WEIGHTS_0"] =
        d.floats("VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    d.json["nodes"][0]["skin"] = 0;
    d.json["nodes"].push_back(Json::object());
    d.json["nodes"].push_back({{"translation", {0, 0, 5}}});
    d.json["scenes"][0]["nodes"] = {0, 1, 2};
    d.json["skins"] = {{{"joints", {1, 2}}}};
    const scene::Loaded skinned = loaded_or_fail(d);
    ASSERT_EQ(skinned.scene.meshes.size(), 1U);
    const auto& positions = skinned.scene.meshes[0].positions_m;
    for (std::size_t v = 0; v < positions.size(); ++v)
        EXPECT_NEAR(positions[v].z, v < 5 ? 0.0F : 5.0F, 0.01F) << v;
}

TEST(GltfLines, morph_targets_move_bodies_whole_at_rest_and_as_clips_play) {
    for (const int mode : {0, 1, 2, 3}) {
        Document d = morphed();
        primitive(d)["mode"] = mode;
        // Normals of a target mean nothing where the bodies have their own.
        primitive(d)["targets"][0]["NORMAL"] = d.positions({9, 9, 9, 9, 9, 9, 9, 9, 9});
        const scene::Scene rest = loaded_or_fail(thin(mode)).scene;
        // Of the two, which go 2 m along z and 4 m along y, a quarter of the first.
        const scene::Scene scene = loaded_or_fail(d).scene;
        const scene::Scene half = posed(d, 0.5);  // a half and a quarter
        ASSERT_EQ(scene.meshes[0].positions_m.size(), rest.meshes[0].positions_m.size()) << mode;
        for (std::size_t v = 0; v < rest.meshes[0].positions_m.size(); ++v) {
            const Vec3& at = rest.meshes[0].positions_m[v];
            EXPECT_LT(math::length(scene.meshes[0].positions_m[v] - at - Vec3(0, 0, 0.5F)), 1e-5F);
            EXPECT_LT(math::length(half.meshes[0].positions_m[v] - at - Vec3(0, 1, 1)), 1e-5F);
            EXPECT_LT(math::length(half.meshes[0].normals[v] - rest.meshes[0].normals[v]), 1e-5F);
        }
        EXPECT_TRUE(half.material_of(half.instances.at(0)).unlit) << mode;
    }
}

TEST(GltfLines, one_point_alone_and_lines_without_length_are_drawn) {
    Document d = thin(0);
    primitive(d)["indices"] = d.accessor<std::uint16_t>("SCALAR", 5123, 1, {1});
    primitive(d)["attributes"]["POSITION"] = d.positions({2, 2, 2, 2, 2, 2});
    EXPECT_EQ(loaded_or_fail(d).scene.triangle_count(), 8U);
    primitive(d)["mode"] = 1;
    primitive(d)["indices"] = d.accessor<std::uint16_t>("SCALAR", 5123, 2, {0, 1});
    const scene::Loaded line = loaded_or_fail(d);
    ASSERT_EQ(line.scene.meshes.size(), 1U);
    for (const Vec3& position : line.scene.meshes[0].positions_m)
        EXPECT_LT(math::length(position - Vec3(2)), 0.01F);
}

TEST(GltfLines, bodies_count_as_memory_and_vertices_before_they_are_made) {
    Document d = thin(0);
    const std::vector<std::uint16_t> many(3000, 0);
    primitive(d)["indices"] = d.accessor("SCALAR", 5123, many.size(), many);
    base::Limits limits;
    limits.vertices = 10'000;
    const auto loaded = load_document(d, {}, limits);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, base::ErrorCode::limit_reached);
    base::Limits small;
    small.memory_bytes = 200'000;
    const auto refused = load_document(d, {}, small);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, base::ErrorCode::limit_reached);
    primitive(d)["indices"] = d.accessor<std::uint16_t>("SCALAR", 5123, 1, {9});
    const auto beyond = load_document(d);
    ASSERT_FALSE(beyond);
    EXPECT_EQ(beyond.error().where, "/meshes/0/primitives/0/indices");
}

}  // namespace
}  // namespace facet::test
