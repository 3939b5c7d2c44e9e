// One point of a scene: what its mesh and its material are, and texture lookups.
// SPDX-License-Identifier: MIT
#pragma once

#include "trace/surface.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {

/// The three vertices of a triangle and how much of each is at the point.
struct Corners {
    std::uint32_t a, b, c;
    float wa, wb, wc;

    template <class T>
    [[nodiscard]] T mix(const std::vector<T>& values) const {
        return values[a] * wa + values[b] * wb + values[c] * wc;
    }
};

inline Corners corners_of(const scene::Mesh& mesh, const Hit& hit) {
    const std::uint32_t* index = mesh.indices.data() + std::size_t{hit.triangle} * 3;
    return {index[0], index[1], index[2], 1.0F - hit.u - hit.v, hit.u, hit.v};
}

/// One point of a scene: what its mesh and its material are, and texture lookups.
class Point {
public:
    Point(const scene::Scene& scene, const Textures& textures, const Hit& hit)
        : instance(scene.instances[hit.instance]),
          mesh(scene.meshes[instance.mesh.index]),
          material(scene.material_of(instance)),
          corners(corners_of(mesh, hit)),
          textures_(textures) {}

    const scene::Instance& instance;
    const scene::Mesh& mesh;
    const scene::Material& material;
    const Corners corners;

    /// Ratio of the ray's width to the triangle, as halvings of a square texture over it; sample()
    /// adds the size.
    void set_footprint(float world_area2_m2, float width_m, float cosine) {
        width_ = width_m / std::max(cosine, 0.05F);
        area2_ = world_area2_m2;
    }
    [[nodiscard]] bool has(tables::TextureSlot slot) const {
        return material.texture(slot).has_value();
    }
    /// Of a ramp, from its left to its right, [0, 1].
    [[nodiscard]] math::Vec4 at_share(tables::TextureSlot slot, float share) const {
        const scene::Texture& texture = *material.texture(slot);
        const float half = 0.5F / static_cast<float>(textures_.size(texture.image).width);
        return textures_.sample(texture, texels(slot), {std::clamp(share, half, 1.0F - half), 0.5F},
                                0.0F);
    }
    [[nodiscard]] math::Vec4 operator()(tables::TextureSlot slot) const {
        const scene::Texture& texture = *material.texture(slot);
        const std::vector<math::Vec2>& uvs =
            texture.uv_set == 1 && !mesh.uv1.empty() ? mesh.uv1 : mesh.uv0;
        if (uvs.empty()) return math::Vec4(1.0F);
        const math::Vec3 uv = texture.uv_from_uv * math::Vec3(corners.mix(uvs), 1.0F);
        return textures_.sample(texture, texels(slot), math::Vec2(uv), level(texture, uvs));
    }

private:
    [[nodiscard]] static tables::Texels texels(tables::TextureSlot slot) {
        return tables::texels_of(tables::material_textures[static_cast<std::size_t>(slot)]);
    }
    [[nodiscard]] float level(const scene::Texture& texture,
                              const std::vector<math::Vec2>& uvs) const {
        if (width_ <= 0.0F || area2_ <= 0.0F) return 0.0F;
        const math::Vec2 ab = uvs[corners.b] - uvs[corners.a];
        const math::Vec2 ac = uvs[corners.c] - uvs[corners.a];
        const math::Mat3& m = texture.uv_from_uv;
        const float scale = std::fabs(m[0][0] * m[1][1] - m[1][0] * m[0][1]);
        const math::Extent size = textures_.size(texture.image);
        const float texels2 = std::fabs(ab.x * ac.y - ab.y * ac.x) * scale *
                              static_cast<float>(size.width) * static_cast<float>(size.height);
        const float texels_wide2 = texels2 / area2_ * width_ * width_;
        return texels_wide2 > 1.0F ? 0.5F * std::log2(texels_wide2) : 0.0F;
    }

    const Textures& textures_;
    float width_ = 0.0F;
    float area2_ = 0.0F;
};

}  // namespace facet::trace
