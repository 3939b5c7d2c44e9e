// Which texels lie beneath one of the next mip level, and by how much.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace facet::image {

/// The source samples beneath one destination sample of a side `from` long, and their shares (sum
/// 1).
struct Taps {
    std::array<std::size_t, 3> at{};
    std::array<float, 3> share{};
};
/// Box of width from/to: two samples, or parts of three when `from` is odd.
[[nodiscard]] inline Taps taps(std::size_t from, std::size_t to, std::size_t index) {
    Taps out;
    const double width = static_cast<double>(from) / static_cast<double>(to);
    const double start = static_cast<double>(index) * width;
    const auto first = static_cast<std::size_t>(start);
    for (std::size_t k = 0; k < 3; ++k) {
        const double low = std::max(start, static_cast<double>(first + k));
        const double high = std::min(start + width, static_cast<double>(first + k + 1));
        out.at[k] = std::min(first + k, from - 1);
        out.share[k] = static_cast<float>(std::max(0.0, high - low) / width);
    }
    return out;
}

}  // namespace facet::image
