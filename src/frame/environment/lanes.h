// Four floats in one register: the compiler's vector types, the same on every machine.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

#include <cstdint>

namespace facet::frame {

/// RGB and an unused lane, or one number of four things at once. Arithmetic and comparisons go lane
/// by lane.
using Lanes = float __attribute__((vector_size(16)));
using IntegerLanes = std::int32_t __attribute__((vector_size(16)));

[[nodiscard]] inline Lanes lanes_of(float x) noexcept { return Lanes{x, x, x, x}; }

/// Four directions, one a lane; they need not be unit.
struct FourDirections {
    Lanes x, y, z;
};
[[nodiscard]] inline FourDirections operator+(const FourDirections& a,
                                              const FourDirections& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] inline FourDirections operator*(const math::Vec3& v, const Lanes& factor) noexcept {
    return {v.x * factor, v.y * factor, v.z * factor};
}

}  // namespace facet::frame
