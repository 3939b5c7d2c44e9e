// Which texture units passes use: 32 in all, which every driver that we know of has.
// SPDX-License-Identifier: MIT
#pragma once

namespace facet::frame {

/// Below: the G-buffer's textures where that is lit, else the first of a material's.
inline constexpr unsigned first_shade_unit = 6;
/// From here on: the rest of a material's.
inline constexpr unsigned end_of_shade_units = 26;
/// Textures that a material can have at once.
inline constexpr int most_material_textures = 32 - (end_of_shade_units - first_shade_unit);

}  // namespace facet::frame
