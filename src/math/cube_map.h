// Cube maps as OpenGL orders and orients their faces (OpenGL 4.5, 8.13, table 8.19).
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

#include <cmath>
#include <cstdint>

namespace facet::math {

/// A place on a cube map: `face` 0..5 is +x -x +y -y +z -z; s to the right and t down its rows,
/// both -1..1.
struct CubePoint {
    std::uint32_t face = 0;
    float s = 0.0F;
    float t = 0.0F;
};

/// Direction of a place on the cube of side 2; its largest component is 1. |s|, |t| > 1 lie beyond
/// the edge.
[[nodiscard]] inline Vec3 direction_from(const CubePoint& point) noexcept {
    const float s = point.s;
    const float t = point.t;
    switch (point.face) {
        case 0:
            return {1.0F, -t, -s};
        case 1:
            return {-1.0F, -t, s};
        case 2:
            return {s, 1.0F, t};
        case 3:
            return {s, -1.0F, -t};
        case 4:
            return {s, -t, 1.0F};
        default:
            return {-s, -t, -1.0F};
    }
}

/// Place of a direction, which need not be unit. Precondition: not zero.
[[nodiscard]] inline CubePoint cube_point_from(const Vec3& d) noexcept {
    const float ax = std::fabs(d.x);
    const float ay = std::fabs(d.y);
    const float az = std::fabs(d.z);
    if (ax >= ay && ax >= az) {
        const float inverse = 1.0F / ax;
        return {d.x < 0.0F ? 1U : 0U, (d.x < 0.0F ? d.z : -d.z) * inverse, -d.y * inverse};
    }
    if (ay >= az) {
        const float inverse = 1.0F / ay;
        return {d.y < 0.0F ? 3U : 2U, d.x * inverse, (d.y < 0.0F ? -d.z : d.z) * inverse};
    }
    const float inverse = 1.0F / az;
    return {d.z < 0.0F ? 5U : 4U, (d.z < 0.0F ? -d.x : d.x) * inverse, -d.y * inverse};
}

}  // namespace facet::math
