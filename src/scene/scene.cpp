// The scene's derived sizes.
// SPDX-License-Identifier: MIT
#include "scene/scene.h"

namespace facet::scene {

std::uint64_t Scene::triangle_count() const {
    std::uint64_t count = 0;
    for (const Instance& instance : instances)
        count += meshes[instance.mesh.index].indices.size() / 3;
    return count;
}

math::Bounds Scene::bounds_m() const {
    math::Bounds bounds;
    for (const Instance& instance : instances) {
        const math::Bounds& box = meshes[instance.mesh.index].bounds_m;
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

}  // namespace facet::scene
