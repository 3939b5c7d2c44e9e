// What a quality is made of: qualities.def's only expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace facet::tables {

/// What rays find for the rasteriser.
struct RayBudget {
    bool shadows = false;            ///< of lights
    std::uint32_t samples = 0;       ///< paths for indirect light at each place; 0: none
    std::uint32_t most_samples = 0;  ///< where they disagree, until
    float error = 0.05F;             ///< this share of the light is uncertain
    std::uint32_t stride = 1;        ///< pixels from one place to the next
    std::uint32_t apart = 1;         ///< places from one that is drawn for to the next
    std::uint32_t bounces = 64;
    float mirrored_alpha = 0.0F;  ///< what smoother surfaces mirror gets a path at every frame,
    std::uint32_t intricate = 0;  ///< and all light this many where surfaces are finer than pixels;
    std::uint32_t most_at_sample = 1;  ///< up to so many where that leaves it too uncertain
    std::uint32_t far = 4;             ///< at a sample, for light through a surface
    bool operator==(const RayBudget&) const = default;
    [[nodiscard]] constexpr bool any() const { return shadows || samples > 0; }
};

/// One row of qualities.def.
struct Quality {
    std::string_view key;
    std::uint32_t frames = 1;    ///< samples per pixel
    bool fast_textures = false;  ///< the nearest mip
    RayBudget rays{};
    std::string_view help;
};
inline constexpr auto qualities = std::to_array<Quality>({
#define QUALITY(name, ...) {.key = #name, __VA_ARGS__},
#include "tables/qualities.def"
});

}  // namespace facet::tables
