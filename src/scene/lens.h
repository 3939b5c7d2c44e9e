// A camera's thin lens, and the exposure that its settings give.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"
#include "scene/scene.h"

namespace facet::scene {

/// Height of the picture's frame in the camera; the full-frame format (contract, "Conventions").
inline constexpr float sensor_height_m = 0.024F;

/// f = h / (2 tan(yfov / 2)).
[[nodiscard]] float focal_length_m(float yfov_rad);
/// Of the entrance pupil: f / (2 N).
[[nodiscard]] float lens_radius_m(float yfov_rad, float f_number);

/// A place on the lens in metres, from its middle, for a pair of numbers in [0, 1): even over a
/// disk (Shirley & Chiu 1997) or over a polygon with a corner at the top.
[[nodiscard]] Vec2 place_on_lens(const Camera& camera, Vec2 u);

/// EV at ISO 100: log2(N^2 / t * 100 / S) (ISO 2720).
[[nodiscard]] double exposure_value(double f_number, double shutter_s, double iso);

}  // namespace facet::scene
