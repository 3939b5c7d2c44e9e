// What a material says in vain.
// SPDX-License-Identifier: MIT
#include "scene/gltf/contradictions.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>

namespace facet::scene::gltf {
namespace {

/// An extension that has a strength, which is 0 where the file gives none.
struct Strength {
    std::string_view extension;
    std::string_view factor;
};
constexpr auto strengths =
    std::to_array<Strength>({{"KHR_materials_anisotropy", "anisotropyStrength"},
                             {"KHR_materials_clearcoat", "clearcoatFactor"},
                             {"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor"},
                             {"KHR_materials_iridescence", "iridescenceFactor"},
                             {"KHR_materials_sheen", "sheenColorFactor"},
                             {"KHR_materials_transmission", "transmissionFactor"}});

bool is_nothing(const Json* value) {
    if (value == nullptr) return true;
    if (value->is_array()) return std::ranges::all_of(*value, [](const Json& x) { return x == 0; });
    return *value == 0;
}

/// Factors alone are what exporters write of everything; who adds a map wants to see it.
void warn_of_unseen_maps(Import& import, const Json& extensions, const std::string& where) {
    for (const Strength& row : strengths) {
        const Json* const extension = find(extensions, row.extension);
        if (extension == nullptr || !is_nothing(find(*extension, row.factor))) continue;
        for (const auto& [name, value] : extension->items())
            if (name.ends_with("Texture"))
                import.warn(fmt::format("{}/extensions/{}/{}", where, row.extension, name),
                            "texture is not seen: its lobe has no strength",
                            fmt::format("{} 0", row.factor));
    }
}

void warn_of_scatter(Import& import, const Json& extensions, const std::string& where) {
    if (find(extensions, "KHR_materials_volume_scatter") == nullptr) return;
    const std::string here = where + "/extensions/KHR_materials_volume_scatter";
    const Json* const volume = find(extensions, "KHR_materials_volume");
    if (volume == nullptr)
        return import.warn(here, "scatters in no volume", {}, "add KHR_materials_volume");
    if (is_nothing(find(*volume, "thicknessFactor")))
        return import.warn(here, "scatters in no volume: a wall of no thickness",
                           "thicknessFactor 0", "make it the thickness of the mesh");
    if (is_nothing(find(*volume, "attenuationDistance")))
        return import.warn(here, "scatters nothing", "no attenuationDistance",
                           "make it the mean way to the next scattering");
    const bool lets_in = find(extensions, "KHR_materials_transmission") != nullptr ||
                         find(extensions, "KHR_materials_diffuse_transmission") != nullptr;
    if (!lets_in)
        import.warn(here, "scatters in a volume that no light enters", {},
                    "add KHR_materials_diffuse_transmission");
}

void warn_of_film(Import& import, const Json& extensions, const std::string& where) {
    const Json* const film = find(extensions, "KHR_materials_iridescence");
    if (film == nullptr) return;
    const bool has_ends = find(*film, "iridescenceThicknessMinimum") != nullptr ||
                          find(*film, "iridescenceThicknessTexture") != nullptr;
    const double low = number_at(*film, "iridescenceThicknessMinimum").value_or(100.0);
    const double high = number_at(*film, "iridescenceThicknessMaximum").value_or(400.0);
    if (has_ends && low > high)
        import.warn(where + "/extensions/KHR_materials_iridescence/iridescenceThicknessMinimum",
                    "the film's least thickness is above its greatest; taken as they stand",
                    fmt::format("{} and {} nm", low, high));
}

}  // namespace

void warn_of_contradictions(Import& import, const Json& json, const std::string& where) {
    const Json* const extensions = find(json, "extensions");
    if (extensions == nullptr || !extensions->is_object()) return;
    warn_of_unseen_maps(import, *extensions, where);
    warn_of_scatter(import, *extensions, where);
    warn_of_film(import, *extensions, where);
}

}  // namespace facet::scene::gltf
