// What a listed light gives at a place, if nothing stands in the way.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

namespace facet::scene {

/// Share of a light's intensity that its range leaves at a distance (KHR_lights_punctual); 1
/// without a range.
[[nodiscard]] float range_window(const Light& light, float distance2_m2);

/// Lux at normal incidence of a light without a size that is not directional, as the rasteriser's
/// light lists give it (KHR_lights_punctual). `to_light` is unit.
[[nodiscard]] Vec3 illuminance_lux(const Light& light, const Vec3& to_light, float distance2_m2);

}  // namespace facet::scene
