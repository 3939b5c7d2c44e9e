// How much the sheen lobe reflects in all: the table that layers of sheen look up.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace facet::brdf {

inline constexpr std::size_t sheen_columns = 32;
inline constexpr std::size_t sheen_rows = 16;

/// [roughness, n_dot_v] at the places of sheen_coordinates() in glsl/brdf/model/layers.glsl, texel
/// centres spanning the whole range: albedo of a lobe of colour 1 (Estevez & Kulla 2017), above 1
/// at grazing angles of smooth fibres. Computed by scripts/fit_sheen.py.
inline constexpr float sheen_charlie[sheen_rows][sheen_columns] = {
#include "brdf/sheen_charlie.inl"
};

/// The table at one direction, bilinear as GL filters it. Arguments in [0, 1].
[[nodiscard]] float sheen_albedo(float n_dot_v, float roughness);

}  // namespace facet::brdf
