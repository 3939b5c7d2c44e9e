// Linearly transformed cosines of the GGX lobe: the table that lights with a size look up.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace facet::brdf {

inline constexpr std::size_t ltc_size = 32;

/// [ltc_size, ltc_size, 4] at the places of ltc_coordinates() in glsl/light/polygon.glsl, texel
/// centres spanning the whole range: elements (0, 0), (0, 2), (2, 0) and (2, 2) of the inverse
/// matrix over its element (1, 1). Fitted by scripts/fit_ltc.py; within 3e-4 of Heitz et al.'s own
/// in the median.
inline constexpr float ltc_ggx[ltc_size * ltc_size][4] = {
#include "brdf/ltc_ggx.inl"
};

}  // namespace facet::brdf
