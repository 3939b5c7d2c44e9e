// Sizes that follow from the scene's values.
// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include "scene/rig.h"

#include <cmath>

namespace facet::scene {

std::uint64_t Scene::triangle_count() const {
    std::uint64_t count = 0;
    for (const Instance& instance : instances)
        count += meshes[instance.mesh.index].indices.size() / 3;
    return count;
}

namespace {

math::Bounds bounds_of(const Scene& scene, bool with_lights) {
    math::Bounds bounds;
    for (const Instance& instance : scene.instances) {
        if (instance.light && !with_lights) continue;
        const math::Bounds& box = scene.meshes[instance.mesh.index].bounds_m;
        if (box.is_empty()) continue;
        for (unsigned corner = 0; corner < 8; ++corner) {
            const Vec3 at((corner & 1U) != 0 ? box.high.x : box.low.x,
                          (corner & 2U) != 0 ? box.high.y : box.low.y,
                          (corner & 4U) != 0 ? box.high.z : box.low.z);
            bounds.add(Vec3(instance.world_from_object * Vec4(at, 1.0F)));
        }
    }
    return bounds;
}

}  // namespace

math::Bounds Scene::bounds_m() const { return bounds_of(*this, false); }
math::Bounds Scene::seen_bounds_m() const { return bounds_of(*this, true); }

std::size_t Scene::memory_bytes() const {
    std::size_t bytes = 0;
    const auto add = [&](const auto& values) { bytes += values.size() * sizeof(values.front()); };
    const auto add_mesh = [&](const Mesh& mesh) {
        add(mesh.positions_m);
        add(mesh.normals);
        add(mesh.tangents);
        add(mesh.uv0);
        add(mesh.uv1);
        add(mesh.colors);
        add(mesh.indices);
    };
    for (const Mesh& mesh : meshes) add_mesh(mesh);
    if (rig != nullptr) {
        for (const Shape& shape : rig->shapes) {
            add_mesh(shape.mesh);
            add(shape.joints);
            add(shape.joint_weights);
            for (const MorphTarget& target : shape.targets) {
                add(target.positions_m);
                add(target.normals);
                add(target.tangents);
            }
        }
        for (const Clip& clip : rig->clips)
            for (const Keyframes& keyframes : clip.keyframes) {
                add(keyframes.times_s);
                add(keyframes.values);
            }
    }
    for (const SceneImage& image : images)
        if (image.pixels != nullptr) bytes += image.pixels->bytes.size();
    return bytes;
}

LightAxes axes_of(const Light& light) {
    const Vec3 z = light.direction;
    const Vec3 up = std::fabs(z.y) < 0.999F ? Vec3(0.0F, 1.0F, 0.0F) : Vec3(0.0F, 0.0F, -1.0F);
    const Vec3 x = math::normalize(math::cross(up, z));
    return {x, math::cross(z, x), z};
}

float area_m2(const Light& light) {
    switch (light.kind) {
        case tables::LightKind::sphere:
            return 4.0F * math::pi * light.radius_m * light.radius_m;
        case tables::LightKind::rect:
            return light.width_m * light.height_m;
        case tables::LightKind::disk:
            return math::pi * light.radius_m * light.radius_m;
        case tables::LightKind::tube:
            return 2.0F * math::pi * light.radius_m * light.width_m;
        case tables::LightKind::directional:
        case tables::LightKind::point:
        case tables::LightKind::spot:
        case tables::LightKind::ies:
            break;
    }
    return 0.0F;
}

}  // namespace facet::scene
