// Colour of a black body by temperature.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

namespace facet::math {

inline constexpr float blackbody_min_k = 1000.0F;
inline constexpr float blackbody_max_k = 15000.0F;

/// Linear Rec.709 of luminance 1, no chromatic adaptation: 6500 K is close to white, not white.
/// Blue that leaves the gamut below about 1900 K is cut at 0, and the luminance restored.
/// `temperature_k` in [blackbody_min_k, blackbody_max_k].
/// Source: Planck 1900, c2 = 1.438776877e-2 m K (CODATA 2018); CIE 15:2004, 7.1, for the sums.
[[nodiscard]] Vec3 blackbody_color(float temperature_k);

}  // namespace facet::math
