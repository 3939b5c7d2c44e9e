// What can be read off a shown picture: its histogram, and where it is clipped.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/image.h"

#include <array>

namespace facet::studio {

struct Histogram {
    static constexpr std::size_t bin_count = 64;
    /// By channel: shares of the pixels, red, green, blue.
    std::array<std::array<float, bin_count>, 3> shares{};
    float clipped_high = 0.0F;  ///< share of the pixels with a channel at its largest code
    float clipped_low = 0.0F;   ///< share with every channel at 0
};
/// Of u8 RGBA; pixels of alpha 0 do not count.
[[nodiscard]] Histogram histogram(const image::Image& shown);

/// u8 RGBA to lay over it: red where a channel is at its largest code, blue where all are at 0, in
/// stripes, so that it is seen on any colour.
[[nodiscard]] image::Image clipping_overlay(const image::Image& shown);

}  // namespace facet::studio
