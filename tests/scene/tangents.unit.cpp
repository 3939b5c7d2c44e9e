// Tangents as MikkTSpace defines them: direction, handedness, seams, degenerate faces.
// SPDX-License-Identifier: MIT
#include "scene/tangents.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "gltf_fixture.h"

namespace facet::test {
namespace {

using math::Vec2;
using math::Vec3;
using math::Vec4;

/// A unit square in the plane z = 0, two triangles, with the coordinates given by corner.
scene::Mesh square(const std::vector<Vec2>& uv) {
    scene::Mesh mesh;
    mesh.positions_m = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, Vec3(0, 0, 1));
    mesh.uv0 = uv;
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

TEST(Tangents, point_along_u_and_the_bitangent_to_the_top_of_the_picture) {
    // v is 1 below and 0 above, as glTF has it: up in the picture is +y.
    scene::Mesh mesh = square({{0, 1}, {1, 1}, {1, 0}, {0, 0}});
    generate_tangents(mesh, 0);
    ASSERT_EQ(mesh.tangents.size(), 4U);
    for (std::size_t v = 0; v < 4; ++v) {
        EXPECT_EQ(mesh.tangents[v], Vec4(1, 0, 0, 1));
        const Vec3 bitangent =
            math::cross(mesh.normals[v], Vec3(mesh.tangents[v])) * mesh.tangents[v].w;
        EXPECT_EQ(bitangent, Vec3(0, 1, 0));
    }
}

TEST(Tangents, mirrored_coordinates_are_left_handed) {
    scene::Mesh mesh = square({{1, 1}, {0, 1}, {0, 0}, {1, 0}});
    generate_tangents(mesh, 0);
    for (const Vec4& tangent : mesh.tangents) EXPECT_EQ(tangent, Vec4(-1, 0, 0, -1));
}

TEST(Tangents, vertices_between_mirrored_halves_are_split) {
    // The left half runs to u = 1, the right half back: two triangles each, sharing the middle.
    scene::Mesh mesh;
    mesh.positions_m = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    mesh.normals.assign(6, Vec3(0, 0, 1));
    mesh.uv0 = {{0, 1}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {0, 0}};
    mesh.colors.assign(6, Vec4(0.5F));
    mesh.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
    generate_tangents(mesh, 0);
    EXPECT_EQ(mesh.positions_m.size(), 8U);
    EXPECT_EQ(mesh.colors.size(), 8U);
    EXPECT_EQ(mesh.uv0.size(), 8U);
    for (std::size_t corner = 0; corner < 6; ++corner)
        EXPECT_EQ(mesh.tangents[mesh.indices[corner]], Vec4(1, 0, 0, 1));
    for (std::size_t corner = 6; corner < 12; ++corner)
        EXPECT_EQ(mesh.tangents[mesh.indices[corner]], Vec4(-1, 0, 0, -1));
    EXPECT_EQ(mesh.positions_m[mesh.indices[6]], Vec3(1, 0, 0));
}

TEST(Tangents, are_the_mean_of_the_faces_weighted_by_angle) {
    // A roof of two faces over one smooth edge: the edge's tangent lies between theirs.
    scene::Mesh mesh;
    mesh.positions_m = {{-1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 1}, {0, 1, 1}, {1, 0, 1}};
    const float half = std::sqrt(0.5F);
    mesh.normals = {{-half, half, 0}, {0, 1, 0}, {half, half, 0},
                    {-half, half, 0}, {0, 1, 0}, {half, half, 0}};
    mesh.uv0 = {{0, 0}, {0.5F, 0}, {1, 0}, {0, 1}, {0.5F, 1}, {1, 1}};
    mesh.indices = {0, 3, 4, 0, 4, 1, 1, 4, 5, 1, 5, 2};
    generate_tangents(mesh, 0);
    ASSERT_EQ(mesh.tangents.size(), 6U);
    EXPECT_NEAR(mesh.tangents[1].x, 1, 1e-5);
    EXPECT_NEAR(mesh.tangents[1].y, 0, 1e-5);
    EXPECT_NEAR(mesh.tangents[0].y, half, 1e-5);
}

TEST(Tangents, without_usable_coordinates_are_any_square_to_the_normal) {
    scene::Mesh mesh = square({{0, 0}, {0, 0}, {0, 0}, {0, 0}});
    generate_tangents(mesh, 0);
    for (const Vec4& tangent : mesh.tangents) {
        EXPECT_NEAR(math::length(Vec3(tangent)), 1, 1e-6);
        EXPECT_NEAR(tangent.z, 0, 1e-6);
    }
}

TEST(Tangents, of_degenerate_faces_are_those_of_their_neighbours) {
    scene::Mesh mesh = square({{0, 1}, {1, 1}, {1, 0}, {0, 0}});
    mesh.indices.insert(mesh.indices.end(), {1, 1, 2});
    generate_tangents(mesh, 0);
    EXPECT_EQ(mesh.positions_m.size(), 4U);
    EXPECT_EQ(mesh.tangents[mesh.indices[6]], Vec4(1, 0, 0, 1));
}

TEST(Tangents, of_many_triangles_over_one_edge_are_made_in_linear_time) {
    scene::Mesh mesh = square({{0, 1}, {1, 1}, {1, 0}, {0, 0}});
    mesh.indices.clear();
    for (int i = 0; i < 200'000; ++i) mesh.indices.insert(mesh.indices.end(), {0, 1, 2});
    generate_tangents(mesh, 0);
    EXPECT_EQ(mesh.indices.size(), 600'000U);
}

TEST(TangentsCorpus, agree_with_those_that_blender_baked_by_mikktspace) {
    const auto path = std::filesystem::path(FACET_SOURCE_DIR) /
                      "../shared/assets/models/ClearCoatTest/ClearCoatTest.glb";
    if (!std::filesystem::is_regular_file(path)) GTEST_SKIP() << "no corpus beside the sources";
    base::ThreadPool pool(1);
    const auto loaded = scene::load(path.string(), {.decode_images = false}, {}, pool);
    ASSERT_TRUE(loaded);
    std::size_t compared = 0;
    for (const scene::Mesh& given : loaded->scene.meshes) {
        if (given.tangents.empty()) continue;
        scene::Mesh made = given;
        generate_tangents(made, 0);
        for (std::size_t corner = 0; corner < made.indices.size(); ++corner) {
            const Vec4& a = given.tangents[given.indices[corner]];
            const Vec4& b = made.tangents[made.indices[corner]];
            ASSERT_EQ(a.w, b.w);
            ASSERT_GT(math::dot(Vec3(a), Vec3(b)), 0.999F);
            ++compared;
        }
    }
    EXPECT_GT(compared, 1000U);
}

}  // namespace
}  // namespace facet::test
