// KHR_materials_pbrSpecularGlossiness: the lecture's other workflow.
// SPDX-License-Identifier: MIT
#include "scene/gltf/specular_glossiness.h"

#include <algorithm>
#include <array>

namespace facet::scene::gltf {
namespace {

float component_at(const Json& object, const char* key, std::size_t index) {
    const Json* const value = element_at(object, key, index);
    return value != nullptr && value->is_number() ? std::clamp(value->get<float>(), 0.0F, 1.0F)
                                                  : 1.0F;
}

struct Place {
    std::string_view key;
    std::string_view pointer;
};
constexpr auto places = std::to_array<Place>(
    {{"base_color", "/extensions/KHR_materials_pbrSpecularGlossiness/diffuseFactor"},
     {"opacity", "/extensions/KHR_materials_pbrSpecularGlossiness/diffuseFactor/3"},
     {"specular_color", "/extensions/KHR_materials_pbrSpecularGlossiness/specularFactor"},
     {"roughness", "/extensions/KHR_materials_pbrSpecularGlossiness/glossinessFactor"},
     {"base_color_texture", "/extensions/KHR_materials_pbrSpecularGlossiness/diffuseTexture"},
     {"specular_color_texture",
      "/extensions/KHR_materials_pbrSpecularGlossiness/specularGlossinessTexture"}});

}  // namespace

void apply_specular_glossiness(const Json& extension, tables::MaterialValues& values) {
    for (std::size_t i = 0; i < 3; ++i) {
        values.base_color[static_cast<int>(i)] = component_at(extension, "diffuseFactor", i);
        values.specular_color[static_cast<int>(i)] = component_at(extension, "specularFactor", i);
    }
    values.opacity = component_at(extension, "diffuseFactor", 3);
    const double glossiness = number_at(extension, "glossinessFactor").value_or(1.0);
    values.roughness = 1.0F - std::clamp(static_cast<float>(glossiness), 0.0F, 1.0F);
    values.metallic = 0.0F;
    values.ior = 0.0F;
    values.specular = 1.0F;
}

std::string_view glossiness_pointer(std::string_view key) {
    const auto* const found = std::ranges::find(places, key, &Place::key);
    return found == places.end() ? std::string_view() : found->pointer;
}

}  // namespace facet::scene::gltf
