// Sample points and the directions they are turned into.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

#include <cmath>
#include <cstdint>

namespace facet::math {

/// Van der Corput's radical inverse in base 2, [0, 1). Source: Niederreiter 1992, definition 3.2.
[[nodiscard]] inline float radical_inverse(std::uint32_t i) noexcept {
    i = (i << 16U) | (i >> 16U);
    i = ((i & 0x00FF00FFU) << 8U) | ((i & 0xFF00FF00U) >> 8U);
    i = ((i & 0x0F0F0F0FU) << 4U) | ((i & 0xF0F0F0F0U) >> 4U);
    i = ((i & 0x33333333U) << 2U) | ((i & 0xCCCCCCCCU) >> 2U);
    i = ((i & 0x55555555U) << 1U) | ((i & 0xAAAAAAAAU) >> 1U);
    return static_cast<float>(i >> 8U) * 0x1p-24F;
}

/// Point i of the Hammersley set of `count` points, centred in its strata in x. Niederreiter
/// 1992, 3.2.
[[nodiscard]] inline Vec2 hammersley(std::uint32_t i, std::uint32_t count) noexcept {
    return {(static_cast<float>(i) + 0.5F) / static_cast<float>(count), radical_inverse(i)};
}

/// GGX normal distribution of a half vector's cosine, 1/sr. Walter et al. 2007, Eq. 33; alpha > 0.
[[nodiscard]] inline float ggx_density(float n_dot_h, float alpha) noexcept {
    const float sin2 = (1.0F - n_dot_h) * (1.0F + n_dot_h);
    const float a_cos = alpha * n_dot_h;
    const float k = alpha / (sin2 + a_cos * a_cos);
    return k * k / pi;
}

/// Cosine of the half vector that GGX's distribution puts at u in [0, 1): density D(h) n.h.
/// tan^2 = alpha^2 u / (1 - u), Walter et al. 2007, Eq. 35.
[[nodiscard]] inline float ggx_sample_cosine(float u, float alpha) noexcept {
    return std::sqrt((1.0F - u) / (1.0F + (alpha * alpha - 1.0F) * u));
}

}  // namespace facet::math
