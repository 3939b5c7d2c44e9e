// The key light: the one light whose BRDF terms the AOVs show.
// SPDX-License-Identifier: MIT
#include "scene/key_light.h"

#include "math/color.h"
#include "scene/light_at.h"

#include <algorithm>
#include <cmath>

namespace facet::scene {
namespace {

using tables::LightKind;

/// A mean direction shorter than this share of the light is noise, not a side it comes from.
constexpr double even_share = 1e-3;

KeyLight place_of(const Light& light) {
    if (light.kind == LightKind::directional) return {Vec4(-light.direction, 0.0F)};
    return {Vec4(light.position_m, 1.0F)};
}

/// Sines and cosines of the azimuths of a picture's columns.
std::vector<glm::dvec2> azimuths(std::uint32_t width) {
    std::vector<glm::dvec2> out;
    for (std::uint32_t x = 0; x < width; ++x) {
        const double azimuth = ((x + 0.5) / width - 0.5) * 2.0 * static_cast<double>(math::pi);
        out.emplace_back(std::sin(azimuth), std::cos(azimuth));
    }
    return out;
}

/// Sum of a row's luminances, as w, and of each times the direction that it comes from.
glm::dvec4 row_moment(std::span<const float> row, double polar,
                      const std::vector<glm::dvec2>& columns) {
    glm::dvec3 level(0.0);  // times sine and cosine of the azimuth, and 1
    for (std::size_t x = 0; x < columns.size(); ++x) {
        const auto nit =
            static_cast<double>(math::luminance(Vec3(row[x * 3], row[x * 3 + 1], row[x * 3 + 2])));
        if (std::isfinite(nit)) level += glm::dvec3(columns[x], 1.0) * nit;
    }
    return {level.x * std::sin(polar), level.z * std::cos(polar), -level.y * std::sin(polar),
            level.z};
}

}  // namespace

Vec3 KeyLight::direction_from(const Vec3& position_m) const {
    const Vec3 way = Vec3(place) - position_m * place.w;
    return way / std::sqrt(std::max(math::dot(way, way), 1e-12F));
}

float illuminance_lux(const Light& light, const Vec3& position_m) {
    const float level = math::luminance(light.color) * light.intensity;
    if (light.kind == LightKind::directional) return level;
    const Vec3 way = light.position_m - position_m;
    const float distance2 = std::max(math::dot(way, way), 1e-12F);
    const float from_axis = -math::dot(way, light.direction) / std::sqrt(distance2);
    const float area = area_m2(light);
    if (area > 0.0F) {
        // A sphere shows a quarter of its area to any side, and a tube about as much.
        const bool is_round = light.kind == LightKind::sphere || light.kind == LightKind::tube;
        const float seen = is_round ? 0.25F : std::max(from_axis, 0.0F);
        return level * area * seen * range_window(light, distance2) /
               std::max(distance2, 0.25F * area);
    }
    return math::luminance(illuminance_lux(light, way / std::sqrt(distance2), distance2));
}

Vec3 dominant_direction(const Environment& environment, float rotation_deg) {
    const auto pixels = environment.latlong->as<float>();
    const math::Extent size = environment.latlong->size;
    const std::vector<glm::dvec2> columns = azimuths(size.width);
    const std::size_t stride = std::size_t{size.width} * 3;
    glm::dvec4 sum(0.0);
    for (std::uint32_t row = 0; row < size.height; ++row) {
        const double polar = (row + 0.5) / size.height * static_cast<double>(math::pi);
        sum += row_moment(pixels.subspan(row * stride, stride), polar, columns) * std::sin(polar);
    }
    const glm::dvec3 mean(sum);
    if (!(glm::length(mean) > even_share * sum.w)) return {0.0F, 1.0F, 0.0F};
    // The environment turns counter-clockwise seen from above (contract, "Conventions").
    return glm::angleAxis(glm::radians(rotation_deg), Vec3(0.0F, 1.0F, 0.0F)) *
           Vec3(glm::normalize(mean));
}

KeyLight key_light(const KeyLightInputs& inputs) {
    const std::vector<Light>& lights = inputs.scene.lights;
    if (inputs.named && *inputs.named < lights.size()) return place_of(lights[*inputs.named]);
    const Vec3 target = inputs.scene.bounds_m().center();
    const Light* strongest = nullptr;
    float most_lux = 0.0F;
    for (const Light& light : lights) {
        const float lux = illuminance_lux(light, target);
        if (!(lux > most_lux)) continue;
        most_lux = lux;
        strongest = &light;
    }
    if (strongest != nullptr) return place_of(*strongest);
    return {Vec4(dominant_direction(inputs.environment, inputs.env_rotation_deg), 0.0F)};
}

}  // namespace facet::scene
