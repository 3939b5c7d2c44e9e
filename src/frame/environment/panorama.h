// A lat-long picture made ready for sampling: four lanes a pixel, scaled, padded, poles filtered.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "frame/environment/lanes.h"
#include "image/image.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace facet::frame {

/// Pixels [height + 2, stride], one row beyond each pole and two columns beyond the seam.
struct Panorama {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::size_t stride = 0;
    std::unique_ptr<Lanes[]> pixels;
};

/// `latlong` [height, width, 3] f32 times `intensity`. Rows near the poles are averaged over as
/// many columns as make a square on the sphere: seen from above, a texel there covers a fan of
/// them.
[[nodiscard]] Panorama make_panorama(const image::Image& latlong, float intensity,
                                     base::ThreadPool& pool);

}  // namespace facet::frame
