// Which parts of the material code a draw needs.
// SPDX-License-Identifier: MIT
#include "frame/upload/material_key.h"

#include "scene/dielectric.h"
#include "scene/layers.h"

#include <spdlog/fmt/fmt.h>

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
    const auto used = [&](TextureSlot slot) { return used_texture(scene, material, slot); };
    const scene::Texture* orm = used(TextureSlot::metallic_roughness_texture);
    const scene::Texture* occlusion = used(TextureSlot::occlusion_texture);
    MaterialKey key;
    key.base_color_texture = used(TextureSlot::base_color_texture) != nullptr;
    key.metallic_roughness_texture = orm != nullptr;
    key.normal_map = used(TextureSlot::normal_texture) != nullptr && !mesh.tangents.empty();
    key.occlusion_packed = occlusion != nullptr && orm != nullptr && same_lookup(*orm, *occlusion);
    key.occlusion_texture = occlusion != nullptr && !key.occlusion_packed;
    key.emissive_texture = used(TextureSlot::emissive_texture) != nullptr;
    key.specular = scene::has_specular(material);
    key.specular_texture = used(TextureSlot::specular_texture) != nullptr;
    key.specular_color_texture = used(TextureSlot::specular_color_texture) != nullptr;
    key.glossiness = key.specular_color_texture && material.has_glossiness;
    key.clearcoat = scene::has_clearcoat(material);
    if (key.clearcoat) {
        key.clearcoat_texture = used(TextureSlot::clearcoat_texture) != nullptr;
        key.clearcoat_roughness_texture = used(TextureSlot::clearcoat_roughness_texture) != nullptr;
        key.clearcoat_normal_map =
            used(TextureSlot::clearcoat_normal_texture) != nullptr && !mesh.tangents.empty();
    }
    key.sheen = scene::has_sheen(material);
    if (key.sheen) {
        key.sheen_color_texture = used(TextureSlot::sheen_color_texture) != nullptr;
        key.sheen_roughness_texture = used(TextureSlot::sheen_roughness_texture) != nullptr;
    }
    key.vertex_color = !mesh.colors.empty();
    key.alpha_mask = material.alpha_mode == scene::AlphaMode::mask;
    for (const auto& texture : material.textures)
        if (texture && (texture->uv_set != 0 || texture->uv_from_uv != math::Mat3(1.0F)))
            key.uv_general = true;
    return key;
}

std::string define(const char* name, bool value) {
    return fmt::format("#define FACET_{} {}\n", name, value ? 1 : 0);
}

std::string defines(const MaterialKey& key) {
    return define("BASE_COLOR_TEXTURE", key.base_color_texture) +
           define("METALLIC_ROUGHNESS_TEXTURE", key.metallic_roughness_texture) +
           define("NORMAL_MAP", key.normal_map) + define("OCCLUSION_PACKED", key.occlusion_packed) +
           define("OCCLUSION_TEXTURE", key.occlusion_texture) +
           define("EMISSIVE_TEXTURE", key.emissive_texture) + define("SPECULAR", key.specular) +
           define("SPECULAR_TEXTURE", key.specular_texture) +
           define("SPECULAR_COLOR_TEXTURE", key.specular_color_texture) +
           define("GLOSSINESS", key.glossiness) + define("CLEARCOAT", key.clearcoat) +
           define("CLEARCOAT_TEXTURE", key.clearcoat_texture) +
           define("CLEARCOAT_ROUGHNESS_TEXTURE", key.clearcoat_roughness_texture) +
           define("CLEARCOAT_NORMAL_MAP", key.clearcoat_normal_map) + define("SHEEN", key.sheen) +
           define("SHEEN_COLOR_TEXTURE", key.sheen_color_texture) +
           define("SHEEN_ROUGHNESS_TEXTURE", key.sheen_roughness_texture) +
           define("TANGENTS", key.normal_map || key.clearcoat_normal_map) +
           define("VERTEX_COLOR", key.vertex_color) + define("UV_GENERAL", key.uv_general) +
           define("ALPHA_MASK", key.alpha_mask);
}

}  // namespace facet::frame
