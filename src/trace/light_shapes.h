// One light and one point: directions to the light, and whether a ray meets it; by the text of
// glsl/light. SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

namespace facet::trace {

/// One way to light a point.
struct LightSample {
    math::Vec3 direction{0.0F};  ///< unit, to the light
    float distance_m = 0.0F;
    math::Vec3 light{0.0F};  ///< nit of a light with a density, else lux at normal incidence
    float pdf = 0.0F;        ///< 1/sr; 0: nothing to light with
    bool has_pdf = false;    ///< it fills an angle, by its size or as a sun
    bool casts_shadow = true;
};

/// A directional light: a direction within the cone that it fills, evenly drawn.
[[nodiscard]] math::Vec3 directional_way(const scene::Light& light, math::Vec2 u);
/// The same with its light.
[[nodiscard]] LightSample sample_directional(const scene::Light& light, math::Vec2 u);
/// Its density, 1/sr, and so its nit for each lux; 0 beside the cone and of one without an angle.
[[nodiscard]] float directional_pdf(const scene::Light& light, const math::Vec3& to_light);

/// A light at a point, seen from where `to_center` begins.
[[nodiscard]] LightSample sample_point(const scene::Light& light, const math::Vec3& to_center);

/// A place of the light given from the point that is lit, drawn uniformly over `area_m2` where its
/// normal is `normal`.
[[nodiscard]] LightSample sample_area(const math::Vec3& to_place, const math::Vec3& normal,
                                      float area_m2);

/// A direction to a light with a size; `light` of the sample is left to the caller.
[[nodiscard]] LightSample sample_shape(const scene::Light& light, const scene::LightAxes& axes,
                                       const math::Vec3& to_center, math::Vec2 u);

/// Distance along a unit direction to a light with a size, or -1; and the density of sample_shape
/// there.
[[nodiscard]] float hit_shape(const scene::Light& light, const scene::LightAxes& axes,
                              const math::Vec3& to_center, const math::Vec3& direction, float& pdf);

}  // namespace facet::trace
