// Projections that a flat view has not: a panorama, and a lens that bends straight lines.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"
#include "scene/scene.h"

namespace facet::scene {

/// Unit, as the camera sees it, for a place of an equirectangular picture, [0, 1) from its top
/// left: the middle is straight ahead, columns to the right turn to the right. What --env reads,
/// where the camera looks along -z.
[[nodiscard]] Vec3 panorama_direction(Vec2 place);

/// Where in the picture of a lens without faults a place of the picture lies that `camera` takes,
/// both in pixels from the top left. With r the distance from the middle, 1 at the corner:
///   r' = r (1 + distortion r^2) (Brown 1966, "Decentering Distortion of Lenses", first radial
///   term),
/// above 0 a barrel, below a cushion; red is larger than green by half the `aberration`, blue
/// smaller. `channel`: 0 red, 1 green, 2 blue.
[[nodiscard]] Vec2 source_of(const Camera& camera, math::Extent size, Vec2 at_px, int channel);
/// How far outside a picture the sources lie at most, as a factor on its sides.
[[nodiscard]] float overscan(const Camera& camera);
[[nodiscard]] bool bends(const Camera& camera);

}  // namespace facet::scene
