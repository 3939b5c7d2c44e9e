// The shapes of lights that are seen themselves, as meshes of the scene.
// SPDX-License-Identifier: MIT
#include "scene/light_shapes.h"

#include "scene/deform.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace facet::scene {
namespace {

using tables::LightKind;

/// Around a circle: a ball 600 pixels wide is 0.4 pixels narrower between two corners than at them.
constexpr std::uint32_t corners = 64;
constexpr std::uint32_t rings = 32;  ///< of a ball, from pole to pole

/// Of a circle of radius 1; `corner` may go around.
Vec2 on_circle(std::uint32_t corner) {
    const float angle = 2.0F * math::pi * static_cast<float>(corner % corners) / corners;
    return {std::cos(angle), std::sin(angle)};
}

void add_vertex(Mesh& mesh, const Vec3& position_m, const Vec3& normal) {
    mesh.positions_m.push_back(position_m);
    mesh.normals.push_back(normal);
    mesh.bounds_m.add(position_m);
}

/// Side 1, in the plane z = 0, its front towards +z.
Mesh square() {
    Mesh mesh;
    for (const Vec2& at :
         {Vec2(-0.5F, -0.5F), Vec2(0.5F, -0.5F), Vec2(0.5F, 0.5F), Vec2(-0.5F, 0.5F)})
        add_vertex(mesh, Vec3(at, 0.0F), {0.0F, 0.0F, 1.0F});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// Radius 1, likewise.
Mesh disk() {
    Mesh mesh;
    for (std::uint32_t i = 0; i < corners; ++i)
        add_vertex(mesh, Vec3(on_circle(i), 0.0F), {0.0F, 0.0F, 1.0F});
    for (std::uint32_t i = 2; i < corners; ++i)
        mesh.indices.insert(mesh.indices.end(), {0, i - 1, i});
    return mesh;
}

/// Radius 1, front outwards.
Mesh ball() {
    Mesh mesh;
    for (std::uint32_t ring = 0; ring <= rings; ++ring)
        for (std::uint32_t i = 0; i < corners; ++i) {
            const float angle = math::pi * static_cast<float>(ring) / rings;
            const Vec2 side = on_circle(i) * std::sin(angle);
            const Vec3 at(side.x, std::cos(angle), -side.y);
            add_vertex(mesh, at, at);
        }
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t i = 0; i < corners; ++i) {
            const std::uint32_t a = ring * corners + i;
            const std::uint32_t b = ring * corners + (i + 1) % corners;
            if (ring + 1 < rings)
                mesh.indices.insert(mesh.indices.end(), {a, a + corners, b + corners});
            if (ring > 0) mesh.indices.insert(mesh.indices.end(), {a, b + corners, b});
        }
    return mesh;
}

/// Length 1 along x, radius 1, front outwards; without its ends.
Mesh tube_side() {
    Mesh mesh;
    for (std::uint32_t i = 0; i < corners; ++i)
        for (const float x : {-0.5F, 0.5F})
            add_vertex(mesh, Vec3(x, on_circle(i)), Vec3(0.0F, on_circle(i)));
    for (std::uint32_t i = 0; i < corners; ++i) {
        const std::uint32_t a = 2 * i;
        const std::uint32_t b = 2 * ((i + 1) % corners);
        mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
    return mesh;
}

Mesh tube_ends() {
    Mesh mesh;
    for (const float side : {-1.0F, 1.0F}) {
        const auto first = static_cast<std::uint32_t>(mesh.positions_m.size());
        for (std::uint32_t i = 0; i < corners; ++i)
            add_vertex(mesh, Vec3(0.5F * side, on_circle(i)), {side, 0.0F, 0.0F});
        for (std::uint32_t i = 2; i < corners; ++i) {
            const std::uint32_t b = first + i - (side > 0.0F ? 1 : 0);
            const std::uint32_t c = first + i - (side > 0.0F ? 0 : 1);
            mesh.indices.insert(mesh.indices.end(), {first, b, c});
        }
    }
    return mesh;
}

/// The other side of it.
Mesh back_of(Mesh mesh) {
    mirror(mesh);
    for (Vec3& normal : mesh.normals) normal = -normal;
    return mesh;
}

/// Where the light shines, and where it does not: nothing for a ball.
std::pair<Mesh, Mesh> parts_of(LightKind kind) {
    if (kind == LightKind::sphere) return {ball(), {}};
    if (kind == LightKind::tube) return {tube_side(), tube_ends()};
    const Mesh front = kind == LightKind::rect ? square() : disk();
    return {front, back_of(front)};
}

/// A mesh of size 1 placed where the light is.
Mat4 world_from_unit(const Light& light) {
    const LightAxes axes = axes_of(light);
    Vec3 size(light.radius_m);
    if (light.kind == LightKind::rect) size = {light.width_m, light.height_m, 1.0F};
    if (light.kind == LightKind::tube) size.x = light.width_m;
    Mat4 out(1.0F);
    out[0] = Vec4(axes.x * size.x, 0.0F);
    out[1] = Vec4(axes.y * size.y, 0.0F);
    out[2] = Vec4(axes.z * size.z, 0.0F);
    out[3] = Vec4(light.position_m, 1.0F);
    return out;
}

/// Sends no light on: only `nit` is seen of it.
Material shining(const std::string& name, const Vec3& nit) {
    Material material{.name = name};
    material.values.base_color = Vec3(0.0F);
    material.values.emissive = nit;
    material.unlit = true;
    return material;
}

}  // namespace

ModelCounts model_counts(const Scene& scene) {
    const auto shape = std::ranges::find_if(
        scene.instances, [](const Instance& instance) { return instance.light.has_value(); });
    if (shape == scene.instances.end())
        return {scene.materials.size(), scene.meshes.size(), scene.instances.size()};
    const std::size_t mesh = shape->mesh.index;
    return {scene.meshes[mesh].material.index, mesh,
            static_cast<std::size_t>(shape - scene.instances.begin())};
}

void remove_light_shapes(Scene& scene) {
    const ModelCounts model = model_counts(scene);
    scene.instances.resize(model.instances);
    scene.meshes.resize(model.meshes);
    scene.materials.resize(model.materials);
}

void place_light_shapes(Scene& scene) {
    remove_light_shapes(scene);
    std::uint32_t object_id = 0;
    for (const Instance& instance : scene.instances)
        object_id = std::max(object_id, instance.object_id);
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        if (!light.is_visible) continue;
        ++object_id;
        auto [bright, dark] = parts_of(light.kind);
        for (Mesh* const part : {&bright, &dark}) {
            if (part->indices.empty()) continue;
            part->name = light.name;
            part->material = {static_cast<std::uint32_t>(scene.materials.size())};
            scene.materials.push_back(
                shining(light.name, part == &bright ? light.color * light.intensity : Vec3(0.0F)));
            scene.instances.push_back({.mesh = {static_cast<std::uint32_t>(scene.meshes.size())},
                                       .world_from_object = world_from_unit(light),
                                       .node = light.name,
                                       .object_id = object_id,
                                       .light = i});
            scene.meshes.push_back(std::move(*part));
        }
    }
}

}  // namespace facet::scene
