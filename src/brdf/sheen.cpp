// How much the sheen lobe reflects in all.
// SPDX-License-Identifier: MIT
#include "brdf/sheen.h"

#include "brdf/terms.h"

#include <algorithm>

namespace facet::brdf {

float sheen_albedo(float n_dot_v, float roughness) {
    using Terms = Terms<float>;
    const Terms::real2 size(sheen_columns, sheen_rows);
    Terms terms;
    const Terms::real2 at = terms.sheen_coordinates(n_dot_v, roughness, size) * size;
    const float x = std::clamp(at.x - 0.5F, 0.0F, size.x - 1.001F);
    const float y = std::clamp(at.y - 0.5F, 0.0F, size.y - 1.001F);
    const auto column = static_cast<std::size_t>(x);
    const auto row = static_cast<std::size_t>(y);
    const float across = x - static_cast<float>(column);
    const float down = y - static_cast<float>(row);
    const auto mixed = [&](std::size_t r) {
        return sheen_charlie[r][column] * (1.0F - across) + sheen_charlie[r][column + 1] * across;
    };
    return mixed(row) * (1.0F - down) + mixed(row + 1) * down;
}

}  // namespace facet::brdf
