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

/// `sh` with the bands l = 1, 2 scaled by 1 / (1 + lambda l^2 (l + 1)^2), with the least lambda
/// (the same for all channels) for which no direction is negative; unchanged where none is. The
/// mean stays. Source: Sloan 2008, "Stupid spherical harmonics tricks", section "Windowing".
[[nodiscard]] std::array<math::Vec3, 9> windowed(const std::array<math::Vec3, 9>& sh);

}  // namespace facet::frame
