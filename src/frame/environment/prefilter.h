// Prefiltered radiance: the environment seen through a GGX lobe of each level's roughness.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "frame/environment/cube_pyramid.h"

#include <cstdint>
#include <vector>

namespace facet::frame {

/// Levels 1 to `levels` - 1 as maps with borders, level i for roughness i / (levels - 1)
/// and of the side face >> i:  integral L(l) D(h) (n.l) dl / integral D(h) (n.l) dl, n = v = l.
/// Karis 2013 Wide lobes are summed over every texel of a small mip. Narrow ones are mixtures of
/// Gaussians and of the wide ones: random samples of a lobe miss a sun or show it as dots, and cost
/// ten times as much.
[[nodiscard]] std::vector<CubeMip> prefilter(const CubePyramid& pyramid, std::uint32_t levels,
                                             base::ThreadPool& pool);

}  // namespace facet::frame
