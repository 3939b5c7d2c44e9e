// One view of the scene: where the camera is and which part of the picture is drawn.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/shared.h"
#include "math/vector.h"
#include "scene/scene.h"

namespace facet::frame {

/// `region` of a picture of `picture` pixels, its corner counted from the top left.
struct Region {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    math::Extent size;
};

/// The view block's camera part for one jittered frame. `jitter_px` is the sample's place in the
/// pixel, relative to its centre, in -0.5..0.5, y down.
/// `lens_m`: the place on the lens that is looked through, from where the camera stands in the
/// middle of its motion or, with `moved`, from there.
[[nodiscard]] shared::View view_block(const scene::Camera& camera, math::Extent picture,
                                      const Region& region, math::Vec2 jitter_px,
                                      math::Vec2 lens_m = math::Vec2(0.0F),
                                      const scene::Camera* moved = nullptr);

/// The view of sample `index` of `count`.
[[nodiscard]] shared::View sample_view(const scene::Camera& camera, math::Extent picture,
                                       const Region& region, std::uint32_t index,
                                       std::uint32_t count);
/// Share of its light that the lens lets through to a pixel of the region, counted from the top
/// left.
[[nodiscard]] float vignetting(const shared::View& view, std::uint32_t x, std::uint32_t y);
/// Its time, [0, 1] from the opening of the shutter to its closing: even over the samples.
[[nodiscard]] float sample_time(std::uint32_t index, std::uint32_t count);
/// Place of sample `index` of `count` in its pixel: N-rooks, centred on 0, the same for every run.
[[nodiscard]] math::Vec2 jitter_px(std::uint32_t index, std::uint32_t count);

}  // namespace facet::frame
