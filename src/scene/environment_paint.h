// Lat-long pictures painted from a function of direction.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "image/image.h"
#include "math/vector.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace facet::scene {

/// Directions of the pixel centres of a lat-long picture: the middle column is -z, columns to its
/// right turn towards +x, row 0 is +y (contract, "Conventions"). Sines and cosines are kept, not
/// computed by pixel.
class LatLong {
public:
    explicit LatLong(math::Extent size);
    [[nodiscard]] math::Extent size() const noexcept { return size_; }
    [[nodiscard]] math::Vec3 direction(std::size_t column, std::size_t row) const noexcept {
        const math::Vec2& around = columns_[column];
        const math::Vec2& down = rows_[row];
        return {down.x * around.x, down.y, -down.x * around.y};
    }
    /// Exact: of everything between two meridians and two parallels.
    [[nodiscard]] float solid_angle_sr(std::size_t row) const noexcept;

private:
    math::Extent size_;
    std::vector<math::Vec2> columns_;  ///< sin and cos of the azimuth from -z
    std::vector<math::Vec2> rows_;     ///< sin and cos of the polar angle
};

/// [height, width, 3] f32 of `row_radiance(y)(direction)`: what depends on the height alone is
/// computed once a row. Called on every thread of `pool`.
template <class RowRadiance>
[[nodiscard]] image::Image paint(const LatLong& map, base::ThreadPool& pool,
                                 const RowRadiance& row_radiance) {
    image::Image picture(map.size(), 3, image::Sample::f32);
    const auto values = picture.as<float>();
    const std::size_t width = map.size().width;
    pool.parallel_for(map.size().height, [&](std::size_t row) {
        const auto radiance = row_radiance(map.direction(0, row).y);
        float* pixel = values.data() + row * width * 3;
        for (std::size_t column = 0; column < width; ++column, pixel += 3) {
            const math::Vec3 nit = radiance(map.direction(column, row));
            pixel[0] = nit.x;
            pixel[1] = nit.y;
            pixel[2] = nit.z;
        }
    });
    return picture;
}

/// Adds a disc of `radius_rad` around `to_sun`, at least one pixel, that gives exactly
/// `illuminance_lux` on a surface facing it.
void add_disc(image::Image& picture, const LatLong& map, const math::Vec3& to_sun, float radius_rad,
              const math::Vec3& illuminance_lux);

}  // namespace facet::scene
