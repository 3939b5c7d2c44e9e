// A cube map of floats that can be sampled anywhere: faces with borders, four look-ups at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "frame/environment/lanes.h"
#include "math/cube_map.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace facet::frame {

/// Faces in GL's order [6, side + 2, side + 2]: each has a border of its neighbours' texels, so
/// that bilinear filtering never looks across an edge.
struct CubeMip {
    std::uint32_t side = 0;
    std::vector<Lanes> texels;

    [[nodiscard]] std::size_t stride() const noexcept { return std::size_t{side} + 2; }
    [[nodiscard]] Lanes& at(std::uint32_t face, std::size_t row, std::size_t column) noexcept {
        return texels[(face * stride() + row + 1) * stride() + column + 1];
    }
    [[nodiscard]] const Lanes& at(std::uint32_t face, std::size_t row,
                                  std::size_t column) const noexcept {
        return texels[(face * stride() + row + 1) * stride() + column + 1];
    }
    /// Bilinear radiance in four directions.
    [[nodiscard]] std::array<Lanes, 4> sample(const FourDirections& d) const noexcept;
};

[[nodiscard]] CubeMip make_mip(std::uint32_t side);
/// Copies the neighbours' edge texels into the borders.
void fill_borders(CubeMip& mip);

/// Where a texel's centre lies on its face, -1..1.
[[nodiscard]] inline float texel_center(std::size_t i, std::uint32_t side) noexcept {
    return (static_cast<float>(i) + 0.5F) / static_cast<float>(side) * 2.0F - 1.0F;
}
/// Solid angle of a small texel at (s, t) over that of one at the middle of the face.
[[nodiscard]] inline float relative_solid_angle(float s, float t) noexcept {
    const float r2 = 1.0F + s * s + t * t;
    return 1.0F / (r2 * std::sqrt(r2));
}

/// The direction of a texel's centre, and a frame around it.
struct TexelFrame {
    math::Vec3 n, t, b;        ///< unit
    float solid_angle = 1.0F;  ///< relative_solid_angle
};
[[nodiscard]] inline TexelFrame texel_frame(std::uint32_t face, std::size_t row, std::size_t column,
                                            std::uint32_t side) noexcept {
    const math::CubePoint point{face, texel_center(column, side), texel_center(row, side)};
    // The sides share one frame around the horizon, so that a filter has no step at their edges.
    const bool is_pole = face == 2 || face == 3;
    const math::Vec3 up = is_pole ? math::Vec3(0.0F, 0.0F, 1.0F) : math::Vec3(0.0F, 1.0F, 0.0F);
    TexelFrame out;
    out.n = math::normalize(math::direction_from(point));
    out.t = math::normalize(math::cross(up, out.n));
    out.b = math::cross(out.n, out.t);
    out.solid_angle = relative_solid_angle(point.s, point.t);
    return out;
}

inline std::array<Lanes, 4> CubeMip::sample(const FourDirections& d) const noexcept {
    // math::cube_point_from for four directions at once, without a branch.
    const Lanes zero{};
    const Lanes ax = d.x < zero ? -d.x : d.x;
    const Lanes ay = d.y < zero ? -d.y : d.y;
    const Lanes az = d.z < zero ? -d.z : d.z;
    const Lanes yz = ay > az ? ay : az;
    const IntegerLanes is_x = ax >= yz;
    const IntegerLanes is_y = ay >= az;
    const IntegerLanes is_pole = ~is_x & is_y;
    const Lanes major = is_x ? d.x : (is_y ? d.y : d.z);
    const IntegerLanes negative = major < zero;
    const Lanes across = is_x ? -d.z : d.x;
    const Lanes s = is_pole ? d.x : (negative ? -across : across);
    const Lanes t = is_pole ? (negative ? -d.z : d.z) : -d.y;
    const Lanes half = lanes_of(0.5F * static_cast<float>(static_cast<std::int32_t>(side)));
    const Lanes scale = half / (is_x ? ax : yz);
    const Lanes px = s * scale + (half + 0.5F);
    const Lanes py = t * scale + (half + 0.5F);
    const IntegerLanes column = __builtin_convertvector(px, IntegerLanes);
    const IntegerLanes row = __builtin_convertvector(py, IntegerLanes);
    const Lanes fx = px - __builtin_convertvector(column, Lanes);
    const Lanes fy = py - __builtin_convertvector(row, Lanes);
    const IntegerLanes y_face{2, 2, 2, 2};
    const IntegerLanes z_face{4, 4, 4, 4};
    // A true comparison is -1.
    const IntegerLanes face = (is_x ? IntegerLanes{} : (is_y ? y_face : z_face)) - negative;
    const auto width = static_cast<std::ptrdiff_t>(side) + 2;
    std::array<Lanes, 4> out;
    for (std::size_t i = 0; i < 4; ++i) {
        const Lanes* top = texels.data() + (face[i] * width + row[i]) * width + column[i];
        const Lanes* bottom = top + width;
        const Lanes a = top[0] + (top[1] - top[0]) * fx[i];
        const Lanes b = bottom[0] + (bottom[1] - bottom[0]) * fx[i];
        out[i] = a + (b - a) * fy[i];
    }
    return out;
}

}  // namespace facet::frame
