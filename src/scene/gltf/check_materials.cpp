// Checks of materials: properties that only make sense together.
// SPDX-License-Identifier: MIT
#include "scene/gltf/check.h"
#include "scene/gltf/schema.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::scene::gltf {
namespace {

/// A material and where it stands.
struct CheckedMaterial {
    const Json& json;
    std::string where;
    Problems& problems;

    [[nodiscard]] const Json* extension(std::string_view name) const {
        const Json* const extensions = find(json, "extensions");
        return extensions != nullptr ? find(*extensions, name) : nullptr;
    }
    /// One that might do what a known one does not.
    [[nodiscard]] bool has_unknown_extension() const {
        for (const auto& [name, value] : find(json, "extensions")->items())
            if (std::none_of(extension_rules().begin(), extension_rules().end(),
                             [&](const ExtensionRule& rule) { return rule.name == name; }))
                return true;
        return false;
    }
    void note(Severity severity, std::string_view code, std::string_view path, std::string what) {
        problems.note(severity, code, where + std::string(path), std::move(what));
    }
};

bool is_zero(const Json* color) {
    if (color == nullptr || !color->is_array()) return true;
    return std::all_of(color->begin(), color->end(), [](const Json& v) { return v == 0; });
}

void check_ior(CheckedMaterial& m) {
    const Json* const extension = m.extension("KHR_materials_ior");
    const auto ior = extension != nullptr ? number_at(*extension, "ior") : std::nullopt;
    if (ior && *ior > 0 && *ior < 1)
        m.problems.error("VALUE_NOT_IN_RANGE", m.where + "/extensions/KHR_materials_ior/ior",
                         "index of refraction is neither 0 nor at least 1",
                         fmt::format("{}", *ior));
}

void check_volume(CheckedMaterial& m) {
    const Json* const volume = m.extension("KHR_materials_volume");
    constexpr std::string_view path = "/extensions/KHR_materials_volume";
    if (volume != nullptr && m.extension("KHR_materials_transmission") == nullptr &&
        m.extension("KHR_materials_diffuse_transmission") == nullptr && !m.has_unknown_extension())
        m.note(Severity::warning, "KHR_MATERIALS_VOLUME_NO_TRANSMISSION", path,
               "a volume that no light enters");
    const double thickness =
        volume != nullptr ? number_at(*volume, "thicknessFactor").value_or(0.0) : 0.0;
    if (thickness > 0 && bool_at(m.json, "doubleSided").value_or(false))
        m.note(Severity::warning, "KHR_MATERIALS_VOLUME_DOUBLE_SIDED", path,
               "a volume with double-sided walls");
    if (m.extension("KHR_materials_dispersion") != nullptr && volume == nullptr)
        m.note(Severity::warning, "KHR_MATERIALS_DISPERSION_NO_VOLUME",
               "/extensions/KHR_materials_dispersion", "dispersion without a volume");
}

void check_iridescence(CheckedMaterial& m) {
    const Json* const film = m.extension("KHR_materials_iridescence");
    if (film == nullptr) return;
    const bool has_texture = find(*film, "iridescenceThicknessTexture") != nullptr;
    const double low = number_at(*film, "iridescenceThicknessMinimum").value_or(100.0);
    const double high = number_at(*film, "iridescenceThicknessMaximum").value_or(400.0);
    if (find(*film, "iridescenceThicknessMinimum") != nullptr && !has_texture)
        m.note(Severity::information, "KHR_MATERIALS_IRIDESCENCE_THICKNESS_RANGE_WITHOUT_TEXTURE",
               "/extensions/KHR_materials_iridescence/iridescenceThicknessMinimum",
               "minimum is used by a texture only");
    if (has_texture && low == high)
        m.note(Severity::information, "KHR_MATERIALS_IRIDESCENCE_THICKNESS_TEXTURE_UNUSED",
               "/extensions/KHR_materials_iridescence/iridescenceThicknessTexture",
               "texture between equal ends");
}

std::uint64_t set_of(const Json* texture) {
    return texture != nullptr ? unsigned_at(*texture, "texCoord").value_or(0) : 0;
}

void check_shared_coordinates(CheckedMaterial& m) {
    const Json* const normal = find(m.json, "normalTexture");
    if (normal == nullptr) return;
    struct Row {
        std::string_view extension;
        std::string_view texture;
        std::string_view code;
    };
    for (const Row& row : {Row{"KHR_materials_anisotropy", "anisotropyTexture",
                               "KHR_MATERIALS_ANISOTROPY_ANISOTROPY_TEXTURE_TEXCOORD"},
                           Row{"KHR_materials_clearcoat", "clearcoatNormalTexture",
                               "KHR_MATERIALS_CLEARCOAT_CLEARCOAT_NORMAL_TEXTURE_TEXCOORD"}}) {
        const Json* const extension = m.extension(row.extension);
        const Json* const texture = extension != nullptr ? find(*extension, row.texture) : nullptr;
        if (texture != nullptr && set_of(texture) != set_of(normal))
            m.note(Severity::warning, row.code,
                   fmt::format("/extensions/{}/{}", row.extension, row.texture),
                   "not the coordinates of the normal map");
    }
}

void check_material(CheckedMaterial& m) {
    if (find(m.json, "alphaCutoff") != nullptr && string_at(m.json, "alphaMode") != "MASK")
        m.note(Severity::warning, "MATERIAL_ALPHA_CUTOFF_INVALID_MODE", "/alphaCutoff",
               "cutoff without alpha mode MASK");
    const Json* const strength = m.extension("KHR_materials_emissive_strength");
    if (strength != nullptr && number_at(*strength, "emissiveStrength").value_or(0.0) > 0 &&
        is_zero(find(m.json, "emissiveFactor")))
        m.note(Severity::warning, "KHR_MATERIALS_EMISSIVE_STRENGTH_ZERO_FACTOR",
               "/extensions/KHR_materials_emissive_strength",
               "emissive strength of a black emissive color");
    check_ior(m);
    check_volume(m);
    check_iridescence(m);
    check_shared_coordinates(m);
}

/// WebP stands in its extension, the core's own formats in `source`.
void check_texture(const Asset& asset, std::size_t index, Problems& problems) {
    const Json& texture = *element_at(asset.json, "textures", index);
    const auto mime_of = [&](std::optional<std::uint32_t> image) {
        const Json* const json = image ? element_at(asset.json, "images", *image) : nullptr;
        if (json == nullptr) return std::string();
        const std::string& found = asset.image_mimes[*image];
        return found.empty() ? string_at(*json, "mimeType") : found;
    };
    const std::string plain = mime_of(index_at(texture, "source"));
    if (!plain.empty() && plain != "image/jpeg" && plain != "image/png")
        problems.error("TEXTURE_INVALID_IMAGE_MIME_TYPE",
                       pointer_text("textures", index, "/source"),
                       "texture source is neither JPEG nor PNG", plain);
    const Json* const webp = find_path(texture, "extensions/EXT_texture_webp");
    const std::string other = webp != nullptr ? mime_of(index_at(*webp, "source")) : std::string();
    if (!other.empty() && other != "image/webp")
        problems.error("TEXTURE_INVALID_IMAGE_MIME_TYPE",
                       pointer_text("textures", index, "/extensions/EXT_texture_webp/source"),
                       "texture source is not WebP", other);
}

}  // namespace

void check_materials(const Asset& asset, Problems& problems) {
    for (std::size_t i = 0; i < count_at(asset.json, "materials"); ++i) {
        CheckedMaterial material{*element_at(asset.json, "materials", i),
                                 pointer_text("materials", i), problems};
        if (material.json.is_object()) check_material(material);
    }
    for (std::size_t i = 0; i < count_at(asset.json, "textures"); ++i)
        check_texture(asset, i, problems);
}

}  // namespace facet::scene::gltf
