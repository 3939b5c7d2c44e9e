// The environment through a lobe so wide that every texel of a small mip counts.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "frame/environment/cube_pyramid.h"

#include <cstdint>

namespace facet::frame {

/// Sum over all texels of the mip of side 16 of L D(h) (n.l) omega over that of D(h) (n.l) omega, n
/// = v = l, for alpha = roughness^2 above about 0.3, where the lobe hardly changes across such a
/// texel.
[[nodiscard]] CubeMip through_wide_lobe(const CubePyramid& pyramid, std::uint32_t side, float alpha,
                                        base::ThreadPool& pool);

}  // namespace facet::frame
