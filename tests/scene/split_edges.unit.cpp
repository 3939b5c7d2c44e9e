// Triangles split until their edges are short.
// SPDX-License-Identifier: MIT
#include "scene/split_edges.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

namespace facet::scene {
namespace {

/// A square of two triangles, one metre wide, facing +z.
Mesh flat_square() {
    Mesh mesh;
    mesh.positions_m = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.uv0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

float longest_edge(const Mesh& mesh, const std::vector<Vec2>& at) {
    float longest = 0.0F;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t next = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
        longest = std::max(longest, math::length(at[mesh.indices[i]] - at[next]));
    }
    return longest;
}

/// How many triangles the edge has that fewest or most have, by the places of its ends.
std::pair<int, int> triangles_an_edge(const Mesh& mesh, const std::vector<std::uint32_t>& places) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> counts;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        ++counts[std::minmax(places[mesh.indices[i]],
                             places[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]])];
    std::pair<int, int> out{99, 0};
    for (const auto& [edge, count] : counts)
        out = {std::min(out.first, count), std::max(out.second, count)};
    return out;
}

TEST(SplitEdges, OfASquareAreHalvedUntilTheyAreShortAndItsAreaStays) {
    Mesh mesh = flat_square();
    std::vector<Vec2> at = mesh.uv0;
    const auto places = split_edges(mesh, at, 0.2F, 1000);
    EXPECT_LE(longest_edge(mesh, at), 0.2F);
    EXPECT_EQ(mesh.indices.size() / 3, 2U * 64U);  // a diagonal of the root of two, halved thrice
    EXPECT_EQ(split_count(flat_square(), flat_square().uv0, 0.2F), 2.0 * 64.0);
    EXPECT_EQ(places.size(), mesh.positions_m.size());
    EXPECT_EQ(mesh.positions_m.size(), 81U);
    float area_m2 = 0.0F;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3 face =
            math::cross(mesh.positions_m[mesh.indices[i + 1]] - mesh.positions_m[mesh.indices[i]],
                        mesh.positions_m[mesh.indices[i + 2]] - mesh.positions_m[mesh.indices[i]]);
        EXPECT_GT(face.z, 0.0F) << "turned round";
        area_m2 += 0.5F * face.z;
    }
    EXPECT_NEAR(area_m2, 1.0F, 1e-5F);
    for (std::size_t v = 0; v < mesh.uv0.size(); ++v) {
        EXPECT_EQ(mesh.uv0[v], Vec2(mesh.positions_m[v].x, 1.0F - mesh.positions_m[v].y));
        EXPECT_EQ(mesh.uv0[v], at[v]);
    }
}

TEST(SplitEdges, LeaveNoCrackWhereNeighboursHaveCoordinatesOfOtherSizes) {
    // Faces of a box have vertices of their own; one has coordinates eight times as wide.
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0F, 1.0F}) {
            const auto first = static_cast<std::uint32_t>(mesh.positions_m.size());
            for (int corner = 0; corner < 4; ++corner) {
                Vec3 p;
                p[axis] = side;
                p[(axis + 1) % 3] = corner == 1 || corner == 2 ? 1.0F : -1.0F;
                p[(axis + 2) % 3] = corner >= 2 ? 1.0F : -1.0F;
                mesh.positions_m.push_back(p);
                mesh.normals.emplace_back(0.0F);
                mesh.normals.back()[axis] = side;
                const float scale = first == 0 ? 8.0F : 1.0F;
                mesh.uv0.emplace_back(scale * p[(axis + 1) % 3], scale * p[(axis + 2) % 3]);
            }
            for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U})
                mesh.indices.push_back(first + i);
        }
    std::vector<Vec2> at = mesh.uv0;
    const auto places = split_edges(mesh, at, 0.9F, 10000);
    EXPECT_GT(mesh.indices.size() / 3, 200U);
    EXPECT_EQ(triangles_an_edge(mesh, places), std::pair(2, 2));
}

TEST(SplitEdges, ThatNoNumberMeasuresStay) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float absurd : {nan, std::numeric_limits<float>::infinity()}) {
        Mesh mesh = flat_square();
        std::vector<Vec2> at = mesh.uv0;
        for (Vec2& place : at) place.x = absurd;
        split_edges(mesh, at, 0.1F, 1000);
        EXPECT_EQ(mesh.indices.size(), 6U);
    }
}

}  // namespace
}  // namespace facet::scene
