// The environment blurred by Gaussians, each twice as wide as the one before.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "frame/environment/cube_pyramid.h"

#include <vector>

namespace facet::frame {

/// The environment convolved with exp(-theta^2 / (2 sigma^2)), theta the angle; normalised.
struct Blurred {
    CubeMip map;
    float sigma_rad = 0.0F;
};

/// Widths from about `finest_rad` (wider where the cube map has no finer texels) in octaves, up to
/// the last that is below `widest_rad`. A texel is at most 0.8 sigma wide, so that bilinear
/// look-ups are smooth.
[[nodiscard]] std::vector<Blurred> make_gaussian_pyramid(const CubePyramid& pyramid,
                                                         float finest_rad, float widest_rad,
                                                         base::ThreadPool& pool);

}  // namespace facet::frame
