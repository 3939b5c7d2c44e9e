// Where the shadow maps of a picture's lights look, and where they lie in their atlas.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"
#include "scene/scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace facet::frame {

inline constexpr std::uint32_t shadow_atlas_px = 4096;
inline constexpr std::uint32_t shadow_tile_min_px = 256;

/// One map.
struct ShadowView {
    math::Mat4 clip_from_world{1.0F};
    float near_m = 0.0F;  ///< along its axis
    float far_m = 0.0F;
    /// Share of the map's width that a metre fills: at one metre, or of parallel light anywhere.
    float width_per_m = 0.0F;
    std::size_t light = 0;  ///< among those that have shadows
};

enum class ShadowKind : std::uint8_t { none, parallel, cone, cube };

/// The maps of one light.
struct ShadowCaster {
    ShadowKind kind = ShadowKind::none;
    std::uint32_t first = 0;  ///< of the views
    std::uint32_t count = 0;
    float radius_m = 0.0F;  ///< of a disk as large as the light; of parallel light per metre
};

/// A grid of maps of one size, row by row from the atlas' lower left.
struct ShadowPlan {
    std::vector<ShadowCaster> casters;  ///< one a light
    std::vector<ShadowView> views;
    std::uint32_t across = 1;  ///< tiles side by side
};

/// Parallel light has up to three maps of slices of what the camera sees (practical splits, Zhang
/// et al. 2006, "Parallel-Split Shadow Maps for Large-Scale Virtual Environments"), fixed to their
/// own texels; cones up to 60 degrees have one, everything else six; lights that there is no room
/// left for cast no shadow. `bounds_m`: of all that casts.
[[nodiscard]] ShadowPlan plan_shadow_views(std::span<const scene::Light> lights,
                                           const scene::Camera& camera, math::Extent picture,
                                           const math::Bounds& bounds_m);

}  // namespace facet::frame
