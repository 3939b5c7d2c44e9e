// A picture in memory: size, channels, sample type and bytes.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace facet::image {

enum class Sample : std::uint8_t { u8, u16, f32 };

[[nodiscard]] constexpr std::size_t sample_bytes(Sample sample) noexcept {
    return sample == Sample::u8 ? 1 : sample == Sample::u16 ? 2 : 4;
}

/// Pixels [height, width, channels], rows from the top, interleaved, no padding; u16 in native byte
/// order. What the numbers mean (sRGB or linear, straight or associated alpha) is the owner's to
/// know.
struct Image {
    math::Extent size;
    std::uint32_t channels = 0;
    Sample sample = Sample::u8;
    std::vector<std::byte> bytes;

    Image() = default;
    /// Zero pixels.
    Image(math::Extent size_, std::uint32_t channels_, Sample sample_)
        : size(size_),
          channels(channels_),
          sample(sample_),
          bytes(static_cast<std::size_t>(size_.pixels()) * channels_ * sample_bytes(sample_)) {}

    [[nodiscard]] std::size_t sample_count() const noexcept {
        return static_cast<std::size_t>(size.pixels()) * channels;
    }
    /// Views as one sample type; the caller has looked at `sample`.
    template <class T>
    [[nodiscard]] std::span<T> as() noexcept {
        return {reinterpret_cast<T*>(bytes.data()), bytes.size() / sizeof(T)};
    }
    template <class T>
    [[nodiscard]] std::span<const T> as() const noexcept {
        return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
    }
};

}  // namespace facet::image
