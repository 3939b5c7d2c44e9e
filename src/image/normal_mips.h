// Mip levels of normal maps, which keep how rough the bumps are that a level no longer shows.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/image.h"

#include <vector>

namespace facet::image {

/// A tangent-space normal map (n = 2 code / 255 - 1, z rebuilt from x and y) and all its mip levels
/// down to 1x1, of the sizes of build_mips(). u8 [height, width, 4].
///
/// RGB: the direction of the mean normal, level 0 as it is. A: the width of the highlight that the
/// bumps beneath make of a mirror, as GGX's and Beckmann's alpha in [0, 1]: alpha^2 is twice the
/// variance of slopes along an axis. 0 in level 0, whatever the picture had there, and where the
/// normals below agree or turn evenly; above 1 it is 1. Bumps count as they are drawn, interpolated
/// between texels, and less what a lookup between texels of the level itself shows of them.
///
/// Sources: Toksvig 2005, "Mipmapping Normal Maps" (the mean normal's length tells the variance);
/// Olano & Baker 2010, "LEAN Mapping" (variances of slopes add up). Precondition: u8, 4 channels,
/// not empty.
[[nodiscard]] std::vector<Image> build_normal_mips(Image rgba8);

}  // namespace facet::image
