// Small scenes for tests: a quad, a sphere, cameras and lights.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

#include <cmath>
#include <memory>
#include <utility>

namespace facet::test {

/// Square of side `side_m` in the plane z = 0, facing +z.
inline scene::Mesh quad(float side_m) {
    const float h = side_m * 0.5F;
    scene::Mesh mesh{.name = "quad", .material = {}};
    mesh.positions_m = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
    mesh.normals.assign(4, math::Vec3(0, 0, 1));
    mesh.uv0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    for (const auto& p : mesh.positions_m) mesh.bounds_m.add(p);
    return mesh;
}

/// Unit sphere with smooth normals; `rings` from pole to pole.
inline scene::Mesh sphere(std::uint32_t rings) {
    scene::Mesh mesh{.name = "sphere", .material = {}};
    const std::uint32_t columns = rings * 2;
    for (std::uint32_t r = 0; r <= rings; ++r)
        for (std::uint32_t c = 0; c <= columns; ++c) {
            const float theta = math::pi * static_cast<float>(r) / static_cast<float>(rings);
            const float phi = 2.0F * math::pi * static_cast<float>(c) / static_cast<float>(columns);
            const math::Vec3 n(std::sin(theta) * std::sin(phi), std::cos(theta),
                               std::sin(theta) * std::cos(phi));
            mesh.positions_m.push_back(n);
            mesh.normals.push_back(n);
        }
    for (std::uint32_t r = 0; r < rings; ++r)
        for (std::uint32_t c = 0; c < columns; ++c) {
            const std::uint32_t a = r * (columns + 1) + c;
            const std::uint32_t b = a + columns + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    for (const auto& p : mesh.positions_m) mesh.bounds_m.add(p);
    return mesh;
}

/// One mesh with one material, at the origin.
inline scene::Scene scene_of(scene::Mesh mesh, const scene::Material& material = {}) {
    scene::Scene scene;
    scene.materials.push_back(material);
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back(
        {.mesh = {0}, .world_from_object = math::Mat4(1.0F), .node = "node", .object_id = 1});
    return scene;
}

/// Adds a mesh with a material of its own.
inline void add(scene::Scene& scene, scene::Mesh mesh, const scene::Material& material,
                const math::Mat4& world_from_object) {
    mesh.material = {static_cast<std::uint32_t>(scene.materials.size())};
    scene.materials.push_back(material);
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back({.mesh = {static_cast<std::uint32_t>(scene.meshes.size() - 1)},
                               .world_from_object = world_from_object,
                               .node = "added",
                               .object_id = static_cast<std::uint32_t>(scene.meshes.size())});
}

/// On the z axis, `distance_m` before the origin, looking at it; orthographic with `half_height_m`
/// above 0.
inline scene::Camera camera_on_z(float distance_m, float half_height_m) {
    scene::Camera camera;
    camera.world_from_view[3] = math::Vec4(0, 0, distance_m, 1);
    camera.projection = scene::Projection::orthographic;
    camera.ymag_m = half_height_m;
    camera.near_m = 0.01F;
    camera.far_m = distance_m * 2.0F + 10.0F;
    return camera;
}

inline scene::Material material(math::Vec3 base_color, float metallic, float roughness) {
    scene::Material m;
    m.values.base_color = base_color;
    m.values.metallic = metallic;
    m.values.roughness = roughness;
    return m;
}

/// A lat-long picture of one radiance.
inline std::shared_ptr<const image::Image> constant_environment(math::Vec3 radiance_nit) {
    auto picture = std::make_shared<image::Image>(math::Extent{64, 32}, 3, image::Sample::f32);
    const auto values = picture->as<float>();
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = radiance_nit[static_cast<int>(i % 3)];
    return picture;
}

}  // namespace facet::test
