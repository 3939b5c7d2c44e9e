// Which parts of the material code a draw needs: a shader permutation, as a value.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

namespace facet::frame {

/// Makes the FACET_ defines of glsl/lib/material.glsl; all are always defined, as 0 or 1.
struct MaterialKey {
    std::uint32_t lobes = 0;        ///< a bit for each tables::Lobe that it has
    std::uint32_t textures = 0;     ///< and for each tables::TextureSlot that is looked up
    bool occlusion_packed = false;  ///< in the red of metallic_roughness_texture
    bool glossiness = false;        ///< in the alpha of specular_color_texture
    bool tangents = false;
    bool vertex_color = false;
    bool uv_general = false;  ///< a UV transform, or the second set
    bool alpha_mask = false;
    auto operator<=>(const MaterialKey&) const = default;
    [[nodiscard]] bool has(tables::TextureSlot slot) const {
        return (textures >> static_cast<unsigned>(slot) & 1U) != 0;
    }
    [[nodiscard]] bool has(tables::Lobe lobe) const {
        return (lobes >> static_cast<unsigned>(lobe) & 1U) != 0;
    }
};

[[nodiscard]] MaterialKey material_key(const scene::Scene& scene, const scene::Material& material,
                                       const scene::Mesh& mesh);
[[nodiscard]] std::string defines(const MaterialKey& key);
/// One `#define FACET_NAME 0|1` line; the name may be in small letters.
[[nodiscard]] std::string define(std::string_view name, bool value);

}  // namespace facet::frame
