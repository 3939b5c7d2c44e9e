// What a frame wrote down of a pixel.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/shared.h"

#include <optional>
#include <vector>

namespace facet::frame {

/// A pixel of the frame's region; 0, 0 is top left.
struct PixelPlace {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
};

struct ExplainedPoint {
    shared::ExplainedSurface surface{};          ///< `which` and `position.w` are used up
    std::vector<shared::ExplainedLight> lights;  ///< those that were evaluated, by their index
};

/// One pixel of one jittered frame.
struct ExplainedPixel {
    math::Vec2 jitter_px{0.0F};  ///< of the sample from the pixel's centre
    float vignetting = 1.0F;     ///< share of the light that the lens lets through
    std::optional<ExplainedPoint> opaque;
    std::vector<ExplainedPoint> blended;       ///< before it, far to near
    std::optional<math::Vec3> background_nit;  ///< seen where nothing is opaque
    math::Vec4 radiance{0.0F};                 ///< what the frame has there: associated alpha
};

}  // namespace facet::frame
