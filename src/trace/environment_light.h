// The environment as the tracer sees it: radiance by direction, and directions drawn where it is
// bright. SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "image/image.h"
#include "math/vector.h"

#include <cstdint>
#include <vector>

namespace facet::trace {

/// A density over cells 0..n-1 that is drawn from by its inverse distribution, so that well spread
/// numbers stay well spread. A guide table makes a draw cost the same whatever n is (Chen & Asau
/// 1974).
class Distribution {
public:
    Distribution() = default;
    explicit Distribution(std::vector<float> weights);

    struct Draw {
        std::uint32_t cell = 0;
        float share = 0.0F;   ///< probability of the cell
        float within = 0.0F;  ///< [0, 1), place in the cell
    };
    [[nodiscard]] Draw draw(float u) const;
    /// Probability of a cell: exactly what draw() does.
    [[nodiscard]] float share(std::uint32_t cell) const {
        return cumulative_[cell + 1] - cumulative_[cell];
    }
    [[nodiscard]] double total() const { return total_; }

private:
    std::vector<float> cumulative_;     ///< n + 1, from 0 to 1
    std::vector<std::uint32_t> guide_;  ///< n: first cell that can hold u in [i/n, (i+1)/n)
    double total_ = 0.0;
};

class EnvironmentLight {
public:
    /// `latlong` f32 [height, width, 3] in nit; it outlives this. Orientation as
    /// scene::Environment.
    EnvironmentLight(const image::Image& latlong, float rotation_deg, float intensity,
                     base::ThreadPool& pool);

    /// Nit from a unit direction, bilinear.
    [[nodiscard]] math::Vec3 radiance(const math::Vec3& direction) const;
    struct Sample {
        math::Vec3 direction{0.0F};
        float pdf = 0.0F;  ///< 1/sr; 0 where there is nothing to draw
    };
    [[nodiscard]] Sample sample(math::Vec2 u) const;
    /// Density of sample() at a unit direction, 1/sr.
    [[nodiscard]] float pdf(const math::Vec3& direction) const;
    [[nodiscard]] bool is_black() const { return rows_.total() <= 0.0; }

private:
    [[nodiscard]] math::Vec2 pixel_of(const math::Vec3& direction) const;

    const image::Image* latlong_;
    float intensity_;
    float rotation_rad_;
    Distribution rows_;
    std::vector<Distribution> columns_;  ///< by row
};

}  // namespace facet::trace
