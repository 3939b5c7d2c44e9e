// Diffuse light of an environment as nine spherical-harmonic coefficients.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/environment/panorama.h"
#include "math/vector.h"

#include <array>

namespace facet::frame {

/// Irradiance / pi, cosine lobe and basis constants folded in (BakedEnvironment::irradiance_sh).
/// The picture is taken as constant within each pixel, and integrated exactly. Nowhere negative:
/// see windowed(). Source: Ramamoorthi & Hanrahan 2001, Eqs. 7 to 11.
[[nodiscard]] std::array<math::Vec3, 9> irradiance_sh(const Panorama& panorama, float rotation_deg);

/// E(n) / pi for unit `n`; what the shader computes.
[[nodiscard]] math::Vec3 evaluate_irradiance(const std::array<math::Vec3, 9>& sh,
                                             const math::Vec3& n);

/// `sh` with bands 1 and 2 scaled by the largest factor up to 1 for which no direction is negative;
/// the mean stays. A lone sun keeps 0.86 of them. Falling windows, as Sloan 2008 ("Stupid Spherical
/// Harmonics Tricks", "Windowing") proposes, take ten times as much from the brightest direction
/// where little is negative.
[[nodiscard]] std::array<math::Vec3, 9> windowed(const std::array<math::Vec3, 9>& sh);

}  // namespace facet::frame
