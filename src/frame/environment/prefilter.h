// Prefiltered radiance: the environment seen through a GGX lobe of each level's roughness.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "frame/environment/cube_pyramid.h"

#include <cstdint>
#include <vector>

namespace facet::frame {

/// Halves [6, side, side, 4] of the environment filtered for `roughness` in (0, 1], with n = v = l:
///   sum L(l) (n.l) / sum (n.l), l drawn by D(h) (n.h) / (4 v.h)      Karis 2013, Eq. 7 and its
///   listing
/// and every look-up in the mip whose texels are as large as the share of the sphere that the
/// sample stands for: Krivanek & Colbert 2008, Eq. 13.
[[nodiscard]] std::vector<std::uint16_t> prefilter(const CubePyramid& pyramid, std::uint32_t side,
                                                   float roughness, base::ThreadPool& pool);

}  // namespace facet::frame
