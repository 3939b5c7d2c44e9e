// Which parts of the material code a draw needs: a shader permutation, as a value.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

#include <compare>
#include <string>

namespace facet::frame {

/// Makes the FACET_ defines of glsl/lib/material.glsl; all are always defined, as 0 or 1.
struct MaterialKey {
    bool base_color_texture = false;
    bool metallic_roughness_texture = false;
    bool normal_map = false;
    bool occlusion_packed = false;   ///< in the red of metallic_roughness_texture
    bool occlusion_texture = false;  ///< a texture of its own
    bool emissive_texture = false;
    bool specular = false;  ///< reflects as no plain dielectric does
    bool specular_texture = false;
    bool specular_color_texture = false;
    bool glossiness = false;  ///< in the alpha of specular_color_texture
    bool clearcoat = false;
    bool clearcoat_texture = false;
    bool clearcoat_roughness_texture = false;
    bool clearcoat_normal_map = false;
    bool sheen = false;
    bool sheen_color_texture = false;
    bool sheen_roughness_texture = false;
    bool vertex_color = false;
    bool uv_general = false;  ///< a UV transform, or the second set
    bool alpha_mask = false;
    auto operator<=>(const MaterialKey&) const = default;
};

[[nodiscard]] MaterialKey material_key(const scene::Scene& scene, const scene::Material& material,
                                       const scene::Mesh& mesh);
[[nodiscard]] std::string defines(const MaterialKey& key);
/// One `#define NAME 0|1` line.
[[nodiscard]] std::string define(const char* name, bool value);

}  // namespace facet::frame
