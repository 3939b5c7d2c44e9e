// The environment as a cube map: level 0 in half floats, and box-filtered mips for the prefilter to read.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/thread_pool.h"
#include "frame/environment/panorama.h"

namespace facet::frame {

/// Four directions, one a lane; they need not be unit.
struct FourDirections {
    Lanes x, y, z;
};

/// One mip, faces in GL's order [6, side + 2, side + 2]: each face has a border of its neighbours' texels, so
/// that bilinear filtering never looks across an edge.
struct CubeMip {
    std::uint32_t side = 0;
    std::vector<Lanes> texels;

    [[nodiscard]] std::size_t stride() const noexcept { return std::size_t{side} + 2; }
    [[nodiscard]] Lanes& at(std::uint32_t face, std::size_t row, std::size_t column) noexcept {
        return texels[(face * stride() + row + 1) * stride() + column + 1];
    }
    /// Sum of the bilinear radiance in four directions.
    [[nodiscard]] Lanes sum_of(const FourDirections& d) const noexcept;
};

struct CubePyramid {
    std::vector<std::uint16_t> level0;  ///< halves [6, face, face, 4]
    std::vector<CubeMip> mips;          ///< mips[i] has the side face >> (i + 1); the last has 4
    bool overflowed = false;            ///< level0 holds values that were cut to the largest half
};

/// Writes one row of texels as halves, alpha 1, and returns whether one was too large for a half.
bool store_halves(const Lanes* row, std::size_t count, std::uint16_t* out);

/// `face_px`: a power of two, at least 16. The panorama is turned counter-clockwise by `rotation_deg`.
[[nodiscard]] CubePyramid make_cube_pyramid(const Panorama& panorama, std::uint32_t face_px,
                                            float rotation_deg, base::ThreadPool& pool);

inline Lanes CubeMip::sum_of(const FourDirections& d) const noexcept {
    using Integers = std::int32_t __attribute__((vector_size(16)));
    const Lanes zero{};
    const Lanes ax = d.x < zero ? -d.x : d.x;
    const Lanes ay = d.y < zero ? -d.y : d.y;
    const Lanes az = d.z < zero ? -d.z : d.z;
    // math::cube_point_from for four directions at once, without a branch.
    const Lanes yz = ay > az ? ay : az;
    const Integers is_x = ax >= yz;
    const Integers is_y = ay >= az;
    const Lanes major = is_x ? d.x : (is_y ? d.y : d.z);
    const Integers negative = major < zero;
    const Lanes side_s = is_x ? -d.z : d.x;
    const Lanes signed_s = negative ? -side_s : side_s;
    const Integers is_pole = ~is_x & is_y;
    const Lanes s = is_pole ? d.x : signed_s;
    const Lanes t = is_pole ? (negative ? -d.z : d.z) : -d.y;
    const Lanes scale = lanes_of(0.5F * static_cast<float>(static_cast<std::int32_t>(side)));
    const Lanes inverse = scale / (is_x ? ax : yz);
    const Lanes px = s * inverse + (scale + 0.5F);
    const Lanes py = t * inverse + (scale + 0.5F);
    const Integers column = __builtin_convertvector(px, Integers);
    const Integers row = __builtin_convertvector(py, Integers);
    const Lanes fx = px - __builtin_convertvector(column, Lanes);
    const Lanes fy = py - __builtin_convertvector(row, Lanes);
    const auto width = static_cast<std::ptrdiff_t>(side) + 2;
    const Integers two{2, 2, 2, 2};
    const Integers four{4, 4, 4, 4};
    const Integers face = (is_x ? Integers{} : (is_y ? two : four)) - negative;
    Lanes sum{};
    for (int i = 0; i < 4; ++i) {
        const Lanes* top = texels.data() + (face[i] * width + row[i]) * width + column[i];
        const Lanes* bottom = top + width;
        const Lanes a = top[0] + (top[1] - top[0]) * fx[i];
        const Lanes b = bottom[0] + (bottom[1] - bottom[0]) * fx[i];
        sum += a + (b - a) * fy[i];
    }
    return sum;
}

}  // namespace facet::frame
