// How much a surface reflects in all: the table that image-based light and energy compensation look
// up. SPDX-License-Identifier: MIT
#pragma once

#include "tables/brdf_terms.h"

#include <cstdint>
#include <vector>

namespace facet::brdf {

/// What is a limit at grazing is evaluated beside it.
inline constexpr double smallest_cosine = 1e-4;

/// RGBA f32 [size (roughness), size (n_dot_v), 4] at the places of
/// glsl/brdf/model/albedo_coordinates.glsl: A and B of the split sum (Karis 2013, Eq. 8: albedo =
/// F0 A + B), the mean of A + B over the hemisphere, and the albedo of the diffuse lobe for a white
/// surface. After bilinear look-up the error of A, B and A + B is below 1e-3 for n_dot_v >= 0.1,
/// below 2.5e-3 for n_dot_v >= 0.01 (roughness >= 0.05), 3e-4 on average.
struct AlbedoTable {
    std::uint32_t size = 0;
    std::vector<float> texels;
};
[[nodiscard]] AlbedoTable albedo_table(const tables::BrdfChoice& choice);

/// The split sum's two terms of the environment's specular lobe at one direction: its albedo is F0
/// a + b for Schlick's Fresnel. For another Fresnel term a and b are such that this holds for F0 =
/// 0.04 and F0 = 1.
struct SplitSum {
    double a = 0.0;
    double b = 0.0;
};
/// By quadrature, error below 2e-5 for roughness >= 0.05. n_dot_v and roughness in [0, 1].
[[nodiscard]] SplitSum split_sum(const tables::BrdfChoice& choice, double n_dot_v,
                                 double roughness);

/// The mean of a + b over the hemisphere, weighted with the cosine. Error below 1e-4.
[[nodiscard]] double average_albedo(const tables::BrdfChoice& choice, double roughness);

}  // namespace facet::brdf
