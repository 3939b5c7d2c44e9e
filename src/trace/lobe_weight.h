// Light with the lobe's weight left out, so that it can be put back at each sample of a pixel.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

#include <algorithm>

namespace facet::trace {

/// A lobe that sends on less than this of the light that it gets tells nothing of that light.
inline constexpr float weight_min = 1e-3F;

/// Component by component; 0 where the divisor is too small to tell.
[[nodiscard]] inline math::Vec3 over(const math::Vec3& a, const math::Vec3& b) {
    math::Vec3 out(0.0F);
    for (int c = 0; c < 3; ++c) out[c] = b[c] > weight_min ? a[c] / b[c] : 0.0F;
    return out;
}

/// A lobe's weight with channels that it hardly has taken from the others.
[[nodiscard]] inline math::Vec3 filled(const math::Vec3& weight) {
    const float most = std::max({weight.x, weight.y, weight.z});
    return glm::max(weight, math::Vec3(0.02F * most));
}

}  // namespace facet::trace
