// How much the sheen lobe reflects in all.
// SPDX-License-Identifier: MIT
#include "brdf/sheen.h"

#include "brdf/terms.h"
#include "math/bilinear.h"

namespace facet::brdf {

float sheen_albedo(float n_dot_v, float roughness) {
    using Terms = Terms<float>;
    const Terms::real2 size(sheen_columns, sheen_rows);
    Terms terms;
    return math::bilinear(
        terms.sheen_coordinates(n_dot_v, roughness, size), size,
        [](std::size_t row, std::size_t column) { return sheen_charlie[row][column]; });
}

}  // namespace facet::brdf
