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

/// A barrel that nothing touches: vignetting is natural alone.
[[nodiscard]] Barrel wide_barrel();
/// One that is as wide as an aperture of f/1.4, and as long that at the corner of a picture of
/// `size` the rim has moved by 0.4 of its diameter: it darkens wide apertures, and nothing from
/// about f/7 on.
[[nodiscard]] Barrel tight_barrel(float yfov_rad, math::Extent size);
/// Share of the light at a place on the picture, given as tangents of the angles to the axis.
[[nodiscard]] float vignetting(const Barrel& barrel, Vec2 tangent, Vec2 lens_m);

/// EV at ISO 100: log2(N^2 / t * 100 / S) (ISO 2720).
[[nodiscard]] double exposure_value(double f_number, double shutter_s, double iso);

}  // namespace facet::scene
