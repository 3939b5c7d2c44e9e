// The glTF extensions this renderer knows.
// SPDX-License-Identifier: MIT
#include "scene/gltf/extensions.h"

#include <algorithm>
#include <array>

namespace facet::scene::gltf {
namespace {

constexpr auto implemented = std::to_array<std::string_view>(
    {"EXT_mesh_gpu_instancing", "EXT_texture_webp", "KHR_lights_punctual",
     "KHR_materials_clearcoat", "KHR_materials_emissive_strength", "KHR_materials_ior",
     "KHR_materials_pbrSpecularGlossiness", "KHR_materials_sheen", "KHR_materials_specular",
     "KHR_materials_unlit", "KHR_materials_variants", "KHR_mesh_quantization",
     "KHR_node_visibility", "KHR_texture_transform"});

struct Loss {
    std::string_view extension;
    std::string_view what;
};
constexpr auto losses = std::to_array<Loss>(
    {{"KHR_draco_mesh_compression", "the geometry, which is compressed with Draco"},
     {"EXT_meshopt_compression", "the geometry, which is compressed with meshoptimizer"},
     {"KHR_meshopt_compression", "the geometry, which is compressed with meshoptimizer"},
     {"KHR_texture_basisu", "the textures, which are KTX2 with Basis Universal"},
     {"EXT_texture_avif", "the textures, which are AVIF"},
     {"MSFT_texture_dds", "the textures, which are DDS"},
     {"KHR_materials_anisotropy", "anisotropic highlights"},
     {"KHR_materials_dispersion", "dispersion"},
     {"KHR_materials_iridescence", "iridescence"},
     {"KHR_materials_transmission", "transparency to light"},
     {"KHR_materials_diffuse_transmission", "light through thin surfaces"},
     {"KHR_materials_volume", "absorption within the volume"},
     {"KHR_animation_pointer", "animated properties"},
     {"EXT_lights_image_based", "the file's own environment"}});

/// Another form of what the file has in plain form as well, unless it is required.
bool has_fallback(std::string_view extension) {
    return extension.ends_with("_compression") || extension == "KHR_texture_basisu" ||
           extension == "EXT_texture_avif" || extension == "MSFT_texture_dds";
}

base::Error missing(const std::string& name) {
    return {.code = base::ErrorCode::feature_missing,
            .where = "/extensionsRequired",
            .what = "required extension is not supported",
            .found = name + ", without it the picture lacks " + std::string(loss_without(name)),
            .remedy = "--ignore-required " + name + " to render it all the same"};
}

}  // namespace

bool is_implemented(std::string_view extension) {
    return std::find(implemented.begin(), implemented.end(), extension) != implemented.end();
}

std::string_view loss_without(std::string_view extension) {
    for (const Loss& loss : losses)
        if (loss.extension == extension) return loss.what;
    return "what it describes";
}

base::Status check_implemented(const Json& json, const LoadOptions& options,
                               base::Warnings& warnings) {
    const auto& ignored = options.ignored_required;
    for (std::size_t i = 0; i < count_at(json, "extensionsRequired"); ++i) {
        const Json& name = *element_at(json, "extensionsRequired", i);
        if (!name.is_string() || is_implemented(name.get<std::string>())) continue;
        const bool is_ignored =
            std::find(ignored.begin(), ignored.end(), name.get<std::string>()) != ignored.end();
        if (!is_ignored) return base::fail(missing(name.get<std::string>()));
    }
    for (std::size_t i = 0; i < count_at(json, "extensionsUsed"); ++i) {
        const Json& name = *element_at(json, "extensionsUsed", i);
        if (!name.is_string() || is_implemented(name.get<std::string>())) continue;
        constexpr std::size_t most = 100;
        if (warnings.size() >= most) break;
        const std::string text = name.get<std::string>();
        warnings.push_back(
            {.file = {},
             .where = "/extensionsUsed",
             .what = "extension is not supported",
             .found = has_fallback(text)
                          ? text + ", the plain data beside it is shown"
                          : text + ", the picture lacks " + std::string(loss_without(text)),
             .remedy = {}});
    }
    return {};
}

}  // namespace facet::scene::gltf
