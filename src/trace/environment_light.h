// The environment as the tracer sees it: radiance by direction, and directions drawn where it is
// bright. SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "image/image.h"
#include "math/vector.h"

#include <cstdint>
#include <span>
#include <vector>

namespace facet::trace {

/// Rows of densities over cells 0..width-1, drawn from by their inverse distribution, so that well
/// spread numbers stay well spread. A guide table makes a draw cost the same whatever the width
/// (Chen & Asau 1974).
class Distribution {
public:
    Distribution() = default;
    /// One row.
    explicit Distribution(std::span<const float> weights) : Distribution(weights.size(), 1) {
        set_row(0, weights);
    }
    /// Rows to be set.
    Distribution(std::size_t width, std::size_t rows);
    /// A row whose weights are all 0 is drawn from evenly. Returns their sum. Rows may be set from
    /// several threads.
    double set_row(std::size_t row, std::span<const float> weights);

    struct Draw {
        std::uint32_t cell = 0;
        float share = 0.0F;   ///< probability of the cell
        float within = 0.0F;  ///< [0, 1), place in the cell
    };
    [[nodiscard]] Draw draw(float u, std::size_t row = 0) const;
    /// Probability of a cell: exactly what draw() does.
    [[nodiscard]] float share(std::size_t cell, std::size_t row = 0) const {
        const float* cumulative = cumulative_.data() + row * (width_ + 1);
        return cumulative[cell + 1] - cumulative[cell];
    }

private:
    std::size_t width_ = 0;
    std::vector<float> cumulative_;  ///< width + 1 a row, from 0 to 1
    std::vector<std::uint32_t>
        guide_;  ///< width a row: first cell that can hold u in [i, i + 1) / width
};

class EnvironmentLight {
public:
    /// `latlong` f32 [height, width, 3] in nit. Orientation as scene::Environment.
    EnvironmentLight(const image::Image& latlong, float rotation_deg, float intensity,
                     base::ThreadPool& pool);

    struct Light {
        math::Vec3 radiance_nit{0.0F};  ///< bilinear
        float pdf = 0.0F;               ///< with which sample() draws the direction, 1/sr
    };
    /// From a unit direction.
    [[nodiscard]] Light at(const math::Vec3& direction) const;
    struct Sample {
        math::Vec3 direction{0.0F};
        Light light;  ///< pdf 0: nothing was drawn
    };
    [[nodiscard]] Sample sample(math::Vec2 u) const;
    /// Irradiance / pi of a surface that looks up, in nit.
    [[nodiscard]] math::Vec3 irradiance_from_above() const;
    [[nodiscard]] bool is_black() const { return is_black_; }

private:
    [[nodiscard]] math::Vec3 radiance(math::Vec2 at_px) const;

    int width_;
    int height_;
    float rotation_rad_;
    float cell_sr_;                   ///< of a cell at the equator
    std::vector<math::Vec4> texels_;  ///< rgb in nit; a: probability of the cell
    Distribution rows_;
    Distribution columns_;
    bool is_black_ = true;
};

}  // namespace facet::trace
