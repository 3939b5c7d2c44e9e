// Materials: factors, textures, and the extensions that this renderer knows.
// SPDX-License-Identifier: MIT
#include "scene/gltf/contradictions.h"
#include "scene/gltf/import.h"
#include "scene/gltf/specular_glossiness.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

namespace facet::scene::gltf {
namespace {

using tables::TextureSlot;

/// The checks have told of what the specification forbids; where it is, and not what became of it.
void tell_clamped(Import& import, const std::string& where, std::string found) {
    constexpr std::size_t most = 1000;
    if (import.warnings.size() >= most) return;
    const auto told = std::ranges::find_if(import.warnings, [&](const base::Warning& warning) {
        return warning.what == "out of range" &&
               (warning.where == where || warning.where.starts_with(where + "/"));
    });
    if (told != import.warnings.end())
        told->what = "out of range, clamped";
    else
        import.warn(where, "out of range, clamped", std::move(found));
}

/// `value` within the range that the table gives `key`; a warning where it was not.
float in_range(Import& import, const std::string& where, std::string_view key, double value) {
    for (const tables::MaterialParam& param : tables::material_params) {
        if (param.key != key) continue;
        const double held = std::clamp(std::isfinite(value) ? value : param.range.low,
                                       param.range.low, param.range.high);
        if (held != value)
            tell_clamped(
                import, where + std::string(param.gltf),
                fmt::format("{}, range {} to {}", value, param.range.low, param.range.high));
        return static_cast<float>(held);
    }
    return static_cast<float>(value);
}

math::Vec3 color_in_range(Import& import, const std::string& where, std::string_view key,
                          const std::vector<double>& values) {
    math::Vec3 out(0.0F);
    for (int i = 0; i < 3; ++i)
        out[i] = in_range(import, where, key, values[static_cast<std::size_t>(i)]);
    return out;
}

Wrap wrap_of(int mode) {
    if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
    if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::mirror;
    return Wrap::repeat;
}

/// The image a texture shows: WebP where offered, else the plain source. Nothing where neither can
/// be used.
std::optional<std::uint32_t> image_of(Import& import, std::size_t texture_index) {
    const Json& json = *element_at(import.asset.json, "textures", texture_index);
    const std::size_t image_count = count_at(import.asset.json, "images");
    const Json* const webp = find_path(json, "extensions/EXT_texture_webp");
    auto source = webp != nullptr ? index_at(*webp, "source") : std::nullopt;
    if (!source) source = index_at(json, "source");
    if (source && *source < image_count) return source;
    const bool is_basis = find_path(json, "extensions/KHR_texture_basisu") != nullptr;
    import.warn(pointer_text("textures", texture_index),
                is_basis ? "texture is white: KTX2 with Basis Universal is not supported"
                         : "texture is white: it has no source");
    return std::nullopt;
}

/// What a coordinate in float still has whole texels for.
constexpr float most_transform = 1e6F;

/// KHR_texture_transform: uv' = T R S uv. The rotation is counter-clockwise as the image is seen,
/// and v points down, hence the sign of the sines.
void apply_transform(Import& import, const Json& transform, const std::string& where,
                     Texture& texture) {
    const auto pair = [&](const char* key, math::Vec2 otherwise) {
        const Json* const values = find(transform, key);
        if (values == nullptr || !values->is_array() || values->size() != 2) return otherwise;
        if (!(*values)[0].is_number() || !(*values)[1].is_number()) return otherwise;
        return math::Vec2((*values)[0].get<float>(), (*values)[1].get<float>());
    };
    const math::Vec2 offset = pair("offset", math::Vec2(0.0F));
    const math::Vec2 scale = pair("scale", math::Vec2(1.0F));
    const auto angle = static_cast<float>(number_at(transform, "rotation").value_or(0.0));
    if (const auto set = index_at(transform, "texCoord")) texture.uv_set = *set;
    for (const float value : {offset.x, offset.y, scale.x, scale.y, angle})
        if (!(std::fabs(value) <= most_transform))
            return import.warn(
                where + "/extensions/KHR_texture_transform", "texture is not moved: out of range",
                fmt::format("{}, range {} to {}", value, -most_transform, most_transform));
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    texture.uv_from_uv = Mat3(Vec3(c * scale.x, -s * scale.x, 0.0F),  // columns
                              Vec3(s * scale.y, c * scale.y, 0.0F), Vec3(offset.x, offset.y, 1.0F));
}

/// The textureInfo `json` at `where`, if it can be used.
std::optional<Texture> convert_texture(Import& import, const Json& json, const std::string& where) {
    const auto index = index_at(json, "index");
    if (!index || *index >= import.model.textures.size()) {
        // What the checks know of is an error before.
        import.warn(where, "texture is ignored: there is no such texture",
                    index
                        ? fmt::format("{}, but there are {}", *index, import.model.textures.size())
                        : "no index");
        return std::nullopt;
    }
    const auto image = image_of(import, *index);
    if (!image) return std::nullopt;
    Texture texture{.image = use_image(import, *image)};
    texture.uv_set = index_at(json, "texCoord").value_or(0);
    if (const Json* const transform = find_path(json, "extensions/KHR_texture_transform"))
        apply_transform(import, *transform, where, texture);
    if (texture.uv_set > 1) {
        import.warn(where, "texture is ignored: only two sets of coordinates are supported",
                    fmt::format("TEXCOORD_{}", texture.uv_set));
        return std::nullopt;
    }
    const int sampler_index = import.model.textures[*index].sampler;
    if (sampler_index >= 0 &&
        static_cast<std::size_t>(sampler_index) < import.model.samplers.size()) {
        const tinygltf::Sampler& sampler =
            import.model.samplers[static_cast<std::size_t>(sampler_index)];
        texture.wrap_u = wrap_of(sampler.wrapS);
        texture.wrap_v = wrap_of(sampler.wrapT);
        texture.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    }
    return texture;
}

void convert_textures(Import& import, const Json& json, const std::string& where,
                      Material& material) {
    for (std::size_t slot = 0; slot < tables::material_textures.size(); ++slot) {
        const std::string_view path = tables::material_textures[slot].gltf;
        const Json* const texture_info = find_path(json, path.substr(1));
        if (texture_info != nullptr)
            material.textures[slot] =
                convert_texture(import, *texture_info, where + std::string(path));
    }
}

void convert_alpha(Import& import, const tinygltf::Material& from, const std::string& where,
                   Material& to) {
    to.double_sided = from.doubleSided;
    if (from.alphaMode == "MASK") to.alpha_mode = AlphaMode::mask;
    if (from.alphaMode == "BLEND") to.alpha_mode = AlphaMode::blend;
    to.values.alpha_cutoff = in_range(import, where, "alpha_cutoff", from.alphaCutoff);
}

void convert_factors(Import& import, const tinygltf::Material& from, const std::string& where,
                     Material& to) {
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    tables::MaterialValues& values = to.values;
    values.base_color = color_in_range(import, where, "base_color", pbr.baseColorFactor);
    values.opacity = in_range(import, where, "opacity", pbr.baseColorFactor[3]);
    values.metallic = in_range(import, where, "metallic", pbr.metallicFactor);
    values.roughness = in_range(import, where, "roughness", pbr.roughnessFactor);
    values.normal_scale = in_range(import, where, "normal_scale", from.normalTexture.scale);
    values.ao_strength = in_range(import, where, "ao_strength", from.occlusionTexture.strength);
    values.emissive = color_in_range(import, where, "emissive", from.emissiveFactor);
}

/// The numbers at pointers of extensions and of this program's extras; a row's initial value stands
/// for what is not there.
void convert_extension_factors(Import& import, const Json& material, const std::string& where,
                               tables::MaterialValues& to) {
    for (const tables::MaterialParam& param : tables::material_params) {
        const bool is_extra = param.gltf.starts_with("/extras/");
        if (!param.gltf.starts_with("/extensions/") && !is_extra) continue;
        const Json* const value = find_path(material, param.gltf.substr(1));
        if (value == nullptr) continue;
        if (const auto* number = std::get_if<float tables::MaterialValues::*>(&param.field)) {
            if (value->is_number())
                to.** number = in_range(import, where, param.key, value->get<double>());
            else if (is_extra)
                import.warn(where + std::string(param.gltf), "not a number, ignored");
            continue;
        }
        if (!value->is_array() || value->size() != 3) continue;
        math::Vec3& color = to.*std::get<tables::Color tables::MaterialValues::*>(param.field);
        for (int i = 0; i < 3; ++i)
            if (const Json& x = (*value)[static_cast<std::size_t>(i)]; x.is_number())
                color[i] = in_range(import, where, param.key, x.get<double>());
    }
}

/// Older drafts of KHR_materials_volume_scatter have another name for the color.
void convert_older_scatter(Import& import, const Json& material, const std::string& where,
                           tables::MaterialValues& to) {
    const std::string path = "/extensions/KHR_materials_volume_scatter/multiscatterColor";
    const Json* const color = find_path(material, path.substr(1));
    if (color == nullptr || find_path(material, path.substr(1) + "Factor") != nullptr) return;
    for (int i = 0; i < 3 && color->is_array() && color->size() == 3; ++i)
        if (const Json& x = (*color)[static_cast<std::size_t>(i)]; x.is_number())
            to.scatter_color[i] = in_range(import, where, "scatter_color", x.get<double>());
}

/// 0 is an index without end, and none is between that and 1.
void hold_ior(tables::MaterialValues& to) {
    if (to.ior > 0.0F) to.ior = std::max(to.ior, 1.0F);
}

/// What the extension has in the place of the core's workflow and of other extensions'.
void convert_glossiness(Import& import, const Json& material, const std::string& where,
                        Material& to) {
    const Json* const extension =
        find_path(material, "extensions/KHR_materials_pbrSpecularGlossiness");
    if (extension == nullptr) return;
    apply_specular_glossiness(*extension, to.values);
    to.has_glossiness = true;
    for (const TextureSlot slot :
         {TextureSlot::base_color_texture, TextureSlot::metallic_roughness_texture,
          TextureSlot::specular_texture, TextureSlot::specular_color_texture}) {
        auto& texture = to.textures[static_cast<std::size_t>(slot)];
        texture.reset();
        const std::string_view pointer =
            glossiness_pointer(tables::material_textures[static_cast<std::size_t>(slot)].key);
        if (pointer.empty()) continue;
        if (const Json* const info = find_path(material, pointer.substr(1)))
            texture = convert_texture(import, *info, where + std::string(pointer));
    }
}

Material convert_material(Import& import, std::size_t index) {
    const tinygltf::Material& from = import.model.materials[index];
    const Json& json = *element_at(import.asset.json, "materials", index);
    const std::string where = pointer_text("materials", index);
    Material to{.source = static_cast<std::uint32_t>(index)};
    to.name = from.name.empty() ? fmt::format("material {}", index) : from.name;
    convert_factors(import, from, where, to);
    convert_alpha(import, from, where, to);
    convert_extension_factors(import, json, where, to.values);
    convert_older_scatter(import, json, where, to.values);
    hold_ior(to.values);
    warn_of_contradictions(import, json, where);
    convert_textures(import, json, where, to);
    to.unlit = find_path(json, "extensions/KHR_materials_unlit") != nullptr;
    convert_glossiness(import, json, where, to);
    return to;
}

bool has_coordinates(const Mesh& mesh, const Texture& texture) {
    return !mesh.uv(texture.uv_set).empty();
}

}  // namespace

void convert_materials(Import& import) {
    for (std::size_t i = 0; i < import.model.materials.size(); ++i)
        import.scene.materials.push_back(convert_material(import, i));
}

void drop_missing_normal_maps(Scene& scene) {
    for (Material& material : scene.materials)
        for (std::size_t slot = 0; slot < material.textures.size(); ++slot) {
            auto& map = material.textures[slot];
            if (map && tables::material_textures[slot].is_normal_map &&
                scene.images[map->image.index].pixels == nullptr)
                map = std::nullopt;
        }
}

MaterialId default_material(Import& import) {
    if (!import.default_material) {
        import.default_material =
            MaterialId{static_cast<std::uint32_t>(import.scene.materials.size())};
        import.scene.materials.push_back({.name = "default"});
    }
    return *import.default_material;
}

MaterialId material_for(Import& import, MaterialId id, const Mesh& mesh, const std::string& where) {
    std::string missing;  // one character a slot
    const Material& material = import.scene.materials[id.index];
    for (std::size_t i = 0; i < material.textures.size(); ++i) {
        const auto& texture = material.textures[i];
        const bool lacks =
            texture && !tables::material_textures[i].is_ramp && !has_coordinates(mesh, *texture);
        missing += lacks ? '-' : '+';
    }
    if (missing.find('-') == std::string::npos) return id;
    if (import.reduced_materials.size() <= id.index) import.reduced_materials.resize(id.index + 1);
    const MaterialId next{static_cast<std::uint32_t>(import.scene.materials.size())};
    const auto [slot, is_new] = import.reduced_materials[id.index].emplace(missing, next);
    import.warn(where, "textures are ignored: the mesh lacks their coordinates",
                import.scene.materials[id.index].name);
    if (!is_new) return slot->second;
    Material reduced = import.scene.materials[id.index];
    for (std::size_t i = 0; i < missing.size(); ++i)
        if (missing[i] == '-') reduced.textures[i] = std::nullopt;
    import.scene.materials.push_back(std::move(reduced));
    return next;
}

}  // namespace facet::scene::gltf
