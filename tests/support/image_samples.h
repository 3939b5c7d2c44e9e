// Pictures for tests: made from numbers, the same each time.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "image/image.h"
#include "image/read.h"
#include "image/write.h"

#include <cstdint>
#include <random>

namespace facet::test {

/// Gradients with some noise: every channel differs, alpha covers 0 to full. f32 spans 0 to
/// about 50.
inline image::Image sample_image(math::Extent size, std::uint32_t channels, image::Sample sample) {
    image::Image out(size, channels, sample);
    std::mt19937 random(7);  // its sequence is fixed by the standard
    std::size_t at = 0;
    for (std::uint32_t y = 0; y < size.height; ++y)
        for (std::uint32_t x = 0; x < size.width; ++x)
            for (std::uint32_t c = 0; c < channels; ++c, ++at) {
                const std::uint32_t noise = static_cast<std::uint32_t>(random()) % 16;
                const std::uint32_t value = (x * 7 + y * 5 + c * 61 + noise) % 256;
                if (sample == image::Sample::u8)
                    out.as<std::uint8_t>()[at] = static_cast<std::uint8_t>(value);
                else if (sample == image::Sample::u16)
                    out.as<std::uint16_t>()[at] = static_cast<std::uint16_t>(value * 251 + noise);
                else
                    out.as<float>()[at] =
                        static_cast<float>(value) * static_cast<float>(value) / 1300.0F;
            }
    return out;
}

/// decode() with default limits; warnings dropped.
inline base::Result<image::Image> decoded(std::span<const std::byte> file) {
    base::Warnings warnings;
    return image::decode(file, base::Limits{}, warnings);
}

inline base::Bytes bytes_of(std::string_view text) {
    const auto view = std::as_bytes(std::span(text));
    return {view.begin(), view.end()};
}

}  // namespace facet::test
