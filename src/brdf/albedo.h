// How much a surface reflects in all: the table that image-based light and energy compensation look up.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "tables/brdf_terms.h"

namespace facet::brdf {

/// RGBA f32 [size (roughness), size (n_dot_v), 4] at the places of glsl/brdf/model/albedo_coordinates.glsl:
/// A and B of the split sum (Karis 2013, Eq. 8: albedo = F0 A + B), the mean of A + B over the hemisphere, and
/// the albedo of the diffuse lobe for a white surface. Error after bilinear look-up below 3e-3.
struct AlbedoTable {
    std::uint32_t size = 0;
    std::vector<float> texels;
};
[[nodiscard]] AlbedoTable albedo_table(const tables::BrdfChoice& choice);

/// The split sum's two terms of the environment's specular lobe at one direction, by quadrature.
struct SplitSum {
    double a = 0.0;
    double b = 0.0;
};
/// n_dot_v and roughness in [0, 1]; `side` squared points. Error about 1 / side^2.
[[nodiscard]] SplitSum split_sum(const tables::BrdfChoice& choice, double n_dot_v, double roughness,
                                 std::uint32_t side);

}  // namespace facet::brdf
