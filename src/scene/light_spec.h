// Lights from text: what --light says.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "base/result.h"
#include "scene/scene.h"

namespace facet::scene {

/// The light that `spec` describes: `KIND:key=value,…`, keys of the kind's row in tables/light_kinds.def.
/// Vectors are `x y z`, angles degrees, `color` is `#rrggbb` (sRGB) or `r g b` (linear), and multiplies the colour
/// of `temperature` (kelvin). Photometric: `lux` on a surface facing it, `candela`, or `lumen`, with
/// I = flux / (4 pi) for a point and flux / (2 pi (1 - cos outer)) for a spot.
/// Without an intensity: 3 lux or 10 candela, so that a metre-sized scene is lit as `studio` lights it.
/// Errors: usage (unknown kind or key, with the nearest right ones; a value out of its range, with the range),
/// feature_missing (a kind of the contract that is not there yet).
[[nodiscard]] base::Result<Light> parse_light(const std::string& spec);

}  // namespace facet::scene
