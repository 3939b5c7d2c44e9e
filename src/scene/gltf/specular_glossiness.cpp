// KHR_materials_pbrSpecularGlossiness as metallic-roughness.
// SPDX-License-Identifier: MIT
#include "scene/gltf/specular_glossiness.h"

#include <algorithm>
#include <cmath>

namespace facet::scene::gltf {
namespace {

using math::Vec3;

constexpr float dielectric_f0 = 0.04F;  // of an index of refraction of 1.5

float component_at(const Json& object, const char* key, std::size_t index, float otherwise) {
    const Json* const value = element_at(object, key, index);
    return value != nullptr && value->is_number() ? std::clamp(value->get<float>(), 0.0F, 1.0F)
                                                  : otherwise;
}

/// Perceived brightness, Finley 2006, "HSP Color Model": sqrt(.299 R^2 + .587 G^2 + .114 B^2).
float brightness_of(const Vec3& c) {
    return std::sqrt(0.299F * c.x * c.x + 0.587F * c.y * c.y + 0.114F * c.z * c.z);
}

/// The metallic m of which lerp(0.04, base, m) has the brightness of the specular color, and base
/// (1 - m) that of the diffuse one: a m^2 + b m + c = 0.
float solve_metallic(float diffuse, float specular, float one_minus_strength) {
    if (specular <= dielectric_f0) return 0.0F;
    const float a = dielectric_f0;
    const float b =
        diffuse * one_minus_strength / (1.0F - dielectric_f0) + specular - 2.0F * dielectric_f0;
    const float c = dielectric_f0 - specular;
    const float d = std::max(b * b - 4.0F * a * c, 0.0F);
    return std::clamp((-b + std::sqrt(d)) / (2.0F * a), 0.0F, 1.0F);
}

}  // namespace

void apply_specular_glossiness(const Json& extension, tables::MaterialValues& values) {
    Vec3 diffuse(1.0F);
    Vec3 specular(1.0F);
    for (int i = 0; i < 3; ++i) {
        diffuse[i] = component_at(extension, "diffuseFactor", static_cast<std::size_t>(i), 1.0F);
        specular[i] = component_at(extension, "specularFactor", static_cast<std::size_t>(i), 1.0F);
    }
    const auto glossiness =
        static_cast<float>(number_at(extension, "glossinessFactor").value_or(1.0));
    const float one_minus_strength = 1.0F - std::max({specular.x, specular.y, specular.z});
    const float m =
        solve_metallic(brightness_of(diffuse), brightness_of(specular), one_minus_strength);
    constexpr float smallest = 1e-6F;
    const Vec3 from_diffuse =
        diffuse * (one_minus_strength / (1.0F - dielectric_f0) / std::max(1.0F - m, smallest));
    const Vec3 from_specular = (specular - dielectric_f0 * (1.0F - m)) / std::max(m, smallest);
    values.base_color = glm::clamp(glm::mix(from_diffuse, from_specular, m * m), 0.0F, 1.0F);
    values.opacity = component_at(extension, "diffuseFactor", 3, 1.0F);
    values.metallic = m;
    values.roughness = 1.0F - std::clamp(glossiness, 0.0F, 1.0F);
}

}  // namespace facet::scene::gltf
