// A lat-long picture made ready for sampling: four lanes a pixel, scaled, padded, poles filtered.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "image/image.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace facet::frame {

/// RGB and an unused lane: one register on every machine Facet runs on, where three floats would be
/// three.
using Lanes = float __attribute__((vector_size(16)));

[[nodiscard]] inline Lanes lanes_of(float x) noexcept { return Lanes{x, x, x, x}; }

/// Sums of one row over azimuth: radiance times 1, cos, sin, cos 2, sin 2 of phi, with phi from -z
/// towards +x.
struct AzimuthMoments {
    Lanes sum[5] = {};
};

/// Pixels [height + 2, stride], one row beyond each pole and two columns beyond the seam.
struct Panorama {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::size_t stride = 0;
    std::vector<Lanes> pixels;
    std::vector<AzimuthMoments> moments;  ///< by row, of the unfiltered picture

    /// Bilinear; x in columns from the centre of the first one, [0, width]; y in rows, [0.5, height
    /// + 0.5], where 1 is the centre of the first row.
    [[nodiscard]] Lanes sample(float x, float y) const noexcept {
        const auto column = static_cast<std::uint32_t>(static_cast<std::int32_t>(x));
        const auto row = static_cast<std::uint32_t>(static_cast<std::int32_t>(y));
        const float fx = x - static_cast<float>(static_cast<std::int32_t>(column));
        const float fy = y - static_cast<float>(static_cast<std::int32_t>(row));
        const Lanes* top = pixels.data() + row * stride + column;
        const Lanes* bottom = top + stride;
        const Lanes a = top[0] + (top[1] - top[0]) * fx;
        const Lanes b = bottom[0] + (bottom[1] - bottom[0]) * fx;
        return a + (b - a) * fy;
    }
};

/// `latlong` [height, width, 3] f32 times `intensity`. Rows near the poles are averaged over as
/// many columns as make a square on the sphere: seen from above, a texel there covers a fan of
/// them.
[[nodiscard]] Panorama make_panorama(const image::Image& latlong, float intensity,
                                     base::ThreadPool& pool);

}  // namespace facet::frame
