// Half floats (IEEE 754 binary16): the bits of one from a float and back.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace facet::math {

inline constexpr float half_max = 65504.0F;

/// Bits of the half nearest to `x` (ties to even). Precondition: 0 <= x <= half_max; radiance is
/// never negative, and without a sign and an infinity the whole is one select, which compilers turn
/// into vector code.
[[nodiscard]] inline std::uint16_t half_from_radiance(float x) noexcept {
    constexpr float smallest_normal = 6.103515625e-5F;  // 2^-14
    constexpr std::uint32_t bias_shift = 112U << 23U;   // float's exponent bias 127, half's 15
    const auto bits = std::bit_cast<std::uint32_t>(x);
    const std::uint32_t rounded = bits + 0xFFFU + ((bits >> 13U) & 1U);
    const std::uint32_t normal = (rounded - bias_shift) >> 13U;
    // The step of floats in [0.5, 1) is 2^-24, that of subnormal halves: the addition does the
    // rounding.
    const std::uint32_t subnormal =
        std::bit_cast<std::uint32_t>(x + 0.5F) - std::bit_cast<std::uint32_t>(0.5F);
    return static_cast<std::uint16_t>(x < smallest_normal ? subnormal : normal);
}

/// The float of a half's bits; exact.
[[nodiscard]] inline float float_from_half(std::uint16_t half) noexcept {
    const std::uint32_t sign = (half & 0x8000U) << 16U;
    const std::uint32_t magnitude = half & 0x7FFFU;
    if (magnitude < 0x400U) {
        const float value = static_cast<float>(magnitude) * 5.9604644775390625e-8F;  // 2^-24
        return sign != 0 ? -value : value;
    }
    const std::uint32_t exponent_fix = magnitude >= 0x7C00U ? 224U << 23U : 112U << 23U;
    return std::bit_cast<float>(sign | ((magnitude << 13U) + exponent_fix));
}

}  // namespace facet::math
