// Coordinates of textures as whole texels.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

#include <algorithm>
#include <cmath>

namespace facet::scene {

/// Texel `i` of `count` as GL wraps it (OpenGL 4.5, 8.14.2).
[[nodiscard]] inline int wrapped(int i, int count, Wrap wrap) {
    if (i >= 0 && i < count) return i;
    switch (wrap) {
        case Wrap::clamp:
            return std::clamp(i, 0, count - 1);
        case Wrap::mirror: {
            const int period = 2 * count;
            const int at = ((i % period) + period) % period;
            return at < count ? at : period - 1 - at;
        }
        case Wrap::repeat:
            break;
    }
    return ((i % count) + count) % count;
}

/// Keeps coordinates that a file made absurd within what int can count.
[[nodiscard]] inline float tame(float x) {
    return std::isfinite(x) ? std::clamp(x, -1e6F, 1e6F) : 0.0F;
}

}  // namespace facet::scene
