// Tables looked up between their texels.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

#include <algorithm>
#include <cstddef>

namespace facet::math {

/// `at` in [0, 1]^2 of a table of `size` columns and rows, bilinear with clamped edges as GL
/// filters it. `texel(row, column)`.
template <class Texel>
[[nodiscard]] auto bilinear(const Vec2& at, const Vec2& size, const Texel& texel) {
    const Vec2 place = at * size - 0.5F;
    const float x = std::clamp(place.x, 0.0F, size.x - 1.001F);
    const float y = std::clamp(place.y, 0.0F, size.y - 1.001F);
    const auto column = static_cast<std::size_t>(x);
    const auto row = static_cast<std::size_t>(y);
    const float across = x - static_cast<float>(column);
    const float down = y - static_cast<float>(row);
    const auto mixed = [&](std::size_t r) {
        return texel(r, column) * (1.0F - across) + texel(r, column + 1) * across;
    };
    return mixed(row) * (1.0F - down) + mixed(row + 1) * down;
}

}  // namespace facet::math
