// Which parts of the material code a draw needs.
// SPDX-License-Identifier: MIT
#include "frame/upload/material_key.h"

#include "frame/texture_units.h"
#include "scene/lobes.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <bit>

namespace facet::frame {
namespace {

using tables::TextureSlot;

/// The texture of a slot, where its image has pixels; a missing image leaves the factor alone.
const scene::Texture* used_texture(const scene::Scene& scene, const scene::Material& material,
                                   TextureSlot slot) {
    const auto& texture = material.texture(slot);
    if (!texture || scene.images[texture->image.index].pixels == nullptr) return nullptr;
    return &*texture;
}

bool same_lookup(const scene::Texture& a, const scene::Texture& b) {
    return a.image == b.image && a.uv_set == b.uv_set && a.uv_from_uv == b.uv_from_uv &&
           a.wrap_u == b.wrap_u && a.wrap_v == b.wrap_v;
}

}  // namespace

MaterialKey material_key(const scene::Scene& scene, const scene::Material& material,
                         const scene::Mesh& mesh) {
    MaterialKey key;
    for (const tables::MaterialLobe& row : tables::material_lobes)
        if (scene::has_lobe(material, row.lobe) &&
            !(row.lobe == tables::Lobe::anisotropy && mesh.tangents.empty()))
            key.lobes |= 1U << static_cast<unsigned>(row.lobe);
    const scene::Texture* orm =
        used_texture(scene, material, TextureSlot::metallic_roughness_texture);
    const scene::Texture* occlusion = used_texture(scene, material, TextureSlot::occlusion_texture);
    key.occlusion_packed = occlusion != nullptr && orm != nullptr && same_lookup(*orm, *occlusion);
    for (std::size_t i = 0; i < tables::material_textures.size(); ++i) {
        const tables::MaterialTexture& row = tables::material_textures[i];
        const auto slot = static_cast<TextureSlot>(i);
        const bool is_read = (row.lobe == tables::Lobe::base || key.has(row.lobe)) &&
                             !row.is_relief && !(row.is_normal_map && mesh.tangents.empty()) &&
                             !(slot == TextureSlot::occlusion_texture && key.occlusion_packed);
        if (!is_read || used_texture(scene, material, slot) == nullptr) continue;
        if (std::popcount(key.textures) == most_material_textures) break;  // factors alone are left
        key.textures |= 1U << i;
        key.tangents = key.tangents || row.is_normal_map;
    }
    key.tangents = key.tangents || key.has(tables::Lobe::anisotropy);
    key.glossiness = key.has(TextureSlot::specular_color_texture) && material.has_glossiness;
    key.vertex_color = !mesh.colors.empty();
    key.alpha_mask = material.alpha_mode == scene::AlphaMode::mask;
    for (const auto& texture : material.textures)
        if (texture && (texture->uv_set != 0 || texture->uv_from_uv != math::Mat3(1.0F)))
            key.uv_general = true;
    return key;
}

std::string define(std::string_view name, bool value) {
    std::string capitals(name);
    std::ranges::transform(capitals, capitals.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
    return fmt::format("#define FACET_{} {}\n", capitals, value ? 1 : 0);
}

std::string defines(const MaterialKey& key) {
    std::string text;
    for (const tables::MaterialLobe& row : tables::material_lobes)
        text += define(row.key, key.has(row.lobe));
    for (std::size_t i = 0; i < tables::material_textures.size(); ++i)
        text += define(tables::material_textures[i].key, key.has(static_cast<TextureSlot>(i)));
    return text + define("OCCLUSION_PACKED", key.occlusion_packed) +
           define("GLOSSINESS", key.glossiness) + define("TANGENTS", key.tangents) +
           define("VERTEX_COLOR", key.vertex_color) + define("UV_GENERAL", key.uv_general) +
           define("ALPHA_MASK", key.alpha_mask);
}

}  // namespace facet::frame
