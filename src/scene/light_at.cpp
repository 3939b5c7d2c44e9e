// What a listed light gives at a place.
// SPDX-License-Identifier: MIT
#include "scene/light_at.h"

#include "brdf/light_terms.h"
#include "scene/light_profile.h"

#include <cmath>

namespace facet::scene {
namespace {

using Terms = brdf::LightTerms<float>;

float inverse_range2(const Light& light) {
    return light.range_m > 0.0F ? 1.0F / (light.range_m * light.range_m) : 0.0F;
}

}  // namespace

float range_window(const Light& light, float distance2_m2) {
    return Terms{}.light_window(distance2_m2, inverse_range2(light));
}

Vec3 illuminance_lux(const Light& light, const Vec3& to_light, float distance2_m2) {
    Terms terms;
    const Vec3 lux =
        terms.light_point(light.color * light.intensity, distance2_m2, inverse_range2(light));
    if (light.profile) return lux * profile_share(light, -to_light);
    if (light.kind != tables::LightKind::spot) return lux;
    const Vec2 edge =
        terms.spot_edge(std::cos(light.inner_cone_rad), std::cos(light.outer_cone_rad));
    return lux * terms.light_spot(-math::dot(to_light, light.direction), edge.x, edge.y);
}

}  // namespace facet::scene
