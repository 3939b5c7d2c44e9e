// The numbers that a path is drawn with: a Sobol sequence, scrambled anew for every pixel and pair
// of dimensions. SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

#include <cstdint>

namespace facet::trace {

/// Bits of `x` in reverse.
[[nodiscard]] constexpr std::uint32_t reversed_bits(std::uint32_t x) noexcept {
    x = __builtin_bswap32(x);
    x = ((x & 0x0F0F0F0FU) << 4U) | ((x >> 4U) & 0x0F0F0F0FU);
    x = ((x & 0x33333333U) << 2U) | ((x >> 2U) & 0x33333333U);
    return ((x & 0x55555555U) << 1U) | ((x >> 1U) & 0x55555555U);
}

/// A hash in which every bit depends on lower bits only: Owen's scrambling of a number whose digits
/// are reversed. Source: Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4), with the
/// constants of Vegdahl 2021.
[[nodiscard]] constexpr std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) noexcept {
    x ^= x * 0x3D20ADEAU;
    x += seed;
    x *= (seed >> 16U) | 1U;
    x ^= x * 0x05526C56U;
    x ^= x * 0x53A22864U;
    return x;
}

/// Well mixed bits of two numbers (the finaliser of MurmurHash3, Appleby 2011).
[[nodiscard]] constexpr std::uint32_t mixed(std::uint32_t a, std::uint32_t b) noexcept {
    std::uint32_t x = a * 0x9E3779B9U + b;
    x ^= x >> 16U;
    x *= 0x85EBCA6BU;
    x ^= x >> 13U;
    x *= 0xC2B2AE35U;
    return x ^ (x >> 16U);
}

/// Sobol's second dimension without its last reversal: digits times Pascal's triangle modulo 2,
/// which is the shift p(t) -> p(t + 1) of the polynomial that the bits are the coefficients of.
[[nodiscard]] constexpr std::uint32_t pascal_product(std::uint32_t x) noexcept {
    x ^= (x & 0xFFFF0000U) >> 16U;
    x ^= (x & 0xFF00FF00U) >> 8U;
    x ^= (x & 0xF0F0F0F0U) >> 4U;
    x ^= (x & 0xCCCCCCCCU) >> 2U;
    return x ^ ((x & 0xAAAAAAAAU) >> 1U);
}

/// Points of one pixel: sample `index` of every pair of dimensions is point `index` of a (0,
/// 2)-sequence in base 2, its order and its digits scrambled by pixel, pair and seed. The first 2^k
/// are a (0, k, 2)-net for every k.
class Sequence {
public:
    Sequence(std::uint32_t pixel, std::uint32_t index, std::uint32_t seed) noexcept
        : seed_(mixed(pixel, seed)), reversed_index_(reversed_bits(index)) {}

    /// The next two dimensions, both in [0, 1).
    [[nodiscard]] math::Vec2 next_pair() noexcept {
        const std::uint32_t seed = mixed(seed_, pair_++);
        const std::uint32_t index = reversed_bits(scrambled(reversed_index_, seed));
        const std::uint32_t x = reversed_bits(scrambled(index, mixed(seed, 1)));
        const std::uint32_t y = reversed_bits(scrambled(pascal_product(index), mixed(seed, 2)));
        return {unit(x), unit(y)};
    }
    /// One dimension, which takes a pair's place.
    [[nodiscard]] float next() noexcept {
        const std::uint32_t seed = mixed(seed_, pair_++);
        return unit(reversed_bits(
            scrambled(reversed_bits(scrambled(reversed_index_, seed)), mixed(seed, 1))));
    }

private:
    /// 24 bits: the largest is below 1 in float.
    [[nodiscard]] static float unit(std::uint32_t x) noexcept {
        return static_cast<float>(x >> 8U) * 5.9604644775390625e-8F;  // 2^-24
    }

    std::uint32_t seed_;
    std::uint32_t reversed_index_;
    std::uint32_t pair_ = 0;
};

}  // namespace facet::trace
