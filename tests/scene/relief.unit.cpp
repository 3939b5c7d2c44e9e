// Height maps as displacement.
// SPDX-License-Identifier: MIT
#include "scene/relief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace facet::scene {
namespace {

using tables::TextureSlot;

/// A map whose first channel is what `height_of` says, 0 to 1, of a texel.
template <class HeightOf>
std::shared_ptr<const image::Image> map_of(math::Extent size, const HeightOf& height_of) {
    image::Image map(size, 1, image::Sample::u16);
    for (std::uint32_t y = 0; y < size.height; ++y)
        for (std::uint32_t x = 0; x < size.width; ++x)
            map.as<std::uint16_t>()[y * size.width + x] =
                static_cast<std::uint16_t>(std::lround(65535.0F * height_of(x, y)));
    return std::make_shared<const image::Image>(std::move(map));
}

/// A square metre that faces +z, its coordinates `repeats` times over the map.
Scene mapped_square(std::shared_ptr<const image::Image> map, float scale_m, float repeats = 1.0F) {
    Scene scene;
    scene.images.push_back({.name = "height", .pixels = std::move(map)});
    Material material;
    material.values.height_scale_m = scale_m;
    material.textures[static_cast<std::size_t>(TextureSlot::height_texture)] =
        Texture{.wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp};
    scene.materials.push_back(material);
    Mesh mesh;
    mesh.positions_m = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    for (const Vec3& p : mesh.positions_m) mesh.uv0.push_back(Vec2(p.x, 1.0F - p.y) * repeats);
    mesh.indices = {0, 1, 2, 0, 2, 3};
    for (const Vec3& p : mesh.positions_m) mesh.bounds_m.add(p);
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back({});
    return scene;
}

/// Rises along x: a texel's middle has the height of its place.
std::shared_ptr<const image::Image> ramp_map() {
    return map_of({16, 16}, [](std::uint32_t x, std::uint32_t) {
        return (static_cast<float>(x) + 0.5F) / 16.0F;
    });
}

bool is_inner(const Vec3& p) { return p.x > 0.1F && p.x < 0.9F; }

TEST(Relief, OfARampStandsOutAsTheMapSaysAndItsNormalsLeanAsItDoes) {
    Scene scene = mapped_square(ramp_map(), 0.5F);
    EXPECT_TRUE(raise_reliefs(scene));
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.indices.size() / 3, 2U * 16U * 16U) << "about a texel each";
    const Vec3 normal = math::normalize(Vec3(-0.5F, 0.0F, 1.0F));  // z = x / 2
    int seen = 0;
    for (std::size_t v = 0; v < mesh.positions_m.size(); ++v) {
        const Vec3& p = mesh.positions_m[v];
        if (!is_inner(p)) continue;  // beyond the outer texels it rises less
        ++seen;
        EXPECT_NEAR(p.z, 0.5F * p.x, 1e-5F);
        if (p.x < 0.17F || p.x > 0.83F) continue;
        EXPECT_LT(math::length(mesh.normals[v] - normal), 1e-4F) << p.x;
    }
    EXPECT_GT(seen, 100);
    // The last texel's middle, and a quarter of a texel less for a quarter of the mean.
    EXPECT_NEAR(mesh.bounds_m.high.z, 0.5F * (15.5F - 0.25F / 4.0F) / 16.0F, 1e-5F);
}

TEST(Relief, IsCarvedInBelowZeroAndAnotherHeightIsNotMadeOfTheFirst) {
    Scene scene = mapped_square(ramp_map(), 0.5F);
    raise_reliefs(scene);
    const std::shared_ptr<const FineMesh> fine = scene.meshes[0].relief->fine;
    EXPECT_FALSE(raise_reliefs(scene)) << "it is there already";
    scene.materials[0].values.height_scale_m = -0.25F;
    EXPECT_TRUE(raise_reliefs(scene));
    EXPECT_EQ(scene.meshes[0].relief->fine, fine) << "triangles stay";
    for (const Vec3& p : scene.meshes[0].positions_m)
        if (is_inner(p)) {
            EXPECT_NEAR(p.z, -0.25F * p.x, 1e-5F);
        }
}

TEST(Relief, IsGoneWithItsMapAndTheMeshIsAsItWas) {
    for (const bool by_scale : {true, false}) {
        Scene scene = mapped_square(ramp_map(), 0.5F);
        const Mesh before = scene.meshes[0];
        raise_reliefs(scene);
        if (by_scale)
            scene.materials[0].values.height_scale_m = 0.0F;
        else
            scene.materials[0].textures[static_cast<std::size_t>(TextureSlot::height_texture)] =
                std::nullopt;
        EXPECT_TRUE(raise_reliefs(scene));
        EXPECT_EQ(scene.meshes[0].positions_m, before.positions_m);
        EXPECT_EQ(scene.meshes[0].normals, before.normals);
        EXPECT_EQ(scene.meshes[0].indices, before.indices);
        EXPECT_EQ(scene.meshes[0].bounds_m.high.z, 0.0F);
        EXPECT_EQ(scene.meshes[0].relief, nullptr);
    }
}

TEST(Relief, MovesVerticesOfOnePlaceTogether) {
    // Two squares at a right angle, with vertices of their own along the edge they share.
    Scene scene = mapped_square(
        map_of({8, 8}, [](auto x, auto y) { return (x + y) % 2 ? 1.0F : 0.5F; }), 0.2F);
    Mesh& mesh = scene.meshes[0];
    for (const Vec3& p : std::vector(mesh.positions_m)) mesh.positions_m.emplace_back(0, p.y, -p.x);
    mesh.normals.resize(8, {-1, 0, 0});
    for (const Vec2& uv : std::vector(mesh.uv0)) mesh.uv0.push_back(uv * 3.0F);
    for (const std::uint32_t i : {4U, 6U, 5U, 4U, 7U, 6U}) mesh.indices.push_back(i);
    raise_reliefs(scene);
    const auto& places = scene.meshes[0].relief->fine->places;
    const auto& fine = scene.meshes[0].relief->fine->mesh;
    std::set<std::uint32_t> shared;
    for (std::size_t v = 0; v < places.size(); ++v) {
        EXPECT_EQ(scene.meshes[0].positions_m[v], scene.meshes[0].positions_m[places[v]]);
        if (places[v] != v) shared.insert(places[v]);
        if (fine.positions_m[v].x == 0.0F && fine.positions_m[v].z == 0.0F) {
            EXPECT_NE(scene.meshes[0].positions_m[v], fine.positions_m[v]);
        }
    }
    EXPECT_GT(shared.size(), 8U);
}

TEST(Relief, OfAMirroredMeshHasItsNormalsOnTheSameSide) {
    Scene scene = mapped_square(ramp_map(), 0.5F);
    Mesh& mesh = scene.meshes[0];
    mesh.is_mirrored = true;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    raise_reliefs(scene);
    for (const Vec3& normal : scene.meshes[0].normals) EXPECT_GT(normal.z, 0.5F);
}

TEST(Relief, UnderANormalMapKeepsTheNormalsThatTheMapTurns) {
    Scene scene = mapped_square(ramp_map(), 0.5F);
    scene.materials[0].textures[static_cast<std::size_t>(TextureSlot::normal_texture)] = Texture{};
    raise_reliefs(scene);
    for (const Vec3& normal : scene.meshes[0].normals) EXPECT_EQ(normal, Vec3(0, 0, 1));
    EXPECT_GT(scene.meshes[0].bounds_m.high.z, 0.4F);
}

TEST(Relief, OfAMapWithMoreTexelsThanTrianglesIsTheMeanOverThem) {
    // Every other column is white; 4,096 texels of that over a metre.
    Scene scene = mapped_square(map_of({64, 64}, [](auto x, auto) { return x % 2 ? 1.0F : 0.0F; }),
                                1.0F, 64.0F);
    auto& map = scene.materials[0].textures[static_cast<std::size_t>(TextureSlot::height_texture)];
    map->wrap_u = Wrap::repeat;
    map->wrap_v = Wrap::repeat;
    raise_reliefs(scene);
    const Mesh& mesh = scene.meshes[0];
    EXPECT_LE(mesh.indices.size() / 3, most_relief_triangles);
    EXPECT_GT(mesh.indices.size() / 3, most_relief_triangles / 5);
    for (const Vec3& p : mesh.positions_m) ASSERT_NEAR(p.z, 0.5F, 0.01F);
}

TEST(Relief, OfAbsurdCoordinatesIsFiniteAndEnds) {
    for (const float absurd : {1e30F, 1e38F, -3e7F, std::numeric_limits<float>::infinity(),
                               std::numeric_limits<float>::quiet_NaN()}) {
        Scene scene = mapped_square(ramp_map(), 0.5F);
        scene.meshes[0].uv0[2].x = absurd;
        raise_reliefs(scene);
        EXPECT_LE(scene.meshes[0].indices.size() / 3, 4 * most_relief_triangles);
        for (const Vec3& p : scene.meshes[0].positions_m)
            ASSERT_TRUE(std::isfinite(p.x + p.y + p.z)) << absurd;
        for (const Vec3& n : scene.meshes[0].normals)
            ASSERT_NEAR(math::length(n), 1.0F, 1e-3F) << absurd;
    }
}

TEST(Relief, OfManyMeshesOfAbsurdCoordinatesStaysWithinOneBudget) {
    Scene scene = mapped_square(ramp_map(), 0.5F);
    scene.meshes[0].uv0[2] = {1e18F, 3e17F};
    scene.meshes.resize(50, scene.meshes[0]);
    raise_reliefs(scene);
    std::size_t triangles = 0;
    for (const Mesh& mesh : scene.meshes) triangles += mesh.indices.size() / 3;
    EXPECT_LE(triangles, 4 * most_relief_triangles);
}

TEST(Relief, OfAMeshThatIsFinerThanAllReliefsMayBeSplitsNothing) {
    Scene scene = mapped_square(ramp_map(), 0.5F);
    std::vector<std::uint32_t>& indices = scene.meshes[0].indices;
    while (indices.size() / 3 <= most_relief_triangles) {
        const std::vector<std::uint32_t> once = indices;
        indices.insert(indices.end(), once.begin(), once.end());
    }
    const std::size_t before = indices.size();
    raise_reliefs(scene);
    EXPECT_EQ(scene.meshes[0].indices.size(), before);
    EXPECT_GT(scene.meshes[0].bounds_m.high.z, 0.1F) << "raised all the same";
}

}  // namespace
}  // namespace facet::scene
