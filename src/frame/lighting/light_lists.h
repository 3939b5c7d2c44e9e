// Which lights reach which part of the picture: lists of 16x16 pixel tiles, built on the CPU.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"
#include "scene/scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace facet::frame {

inline constexpr std::uint32_t tile_px = 16;  ///< lighting/shade.glsl's TILE_PX

inline constexpr std::size_t light_texels = 5;  ///< a light; lighting/shade.glsl's LIGHT_TEXELS

/// What `kind` says in PackedLights; lighting/area.glsl has the same numbers.
namespace packed_kind {
inline constexpr float sun = -1.0F;  ///< an environment's
inline constexpr float rect = 1.0F;
inline constexpr float disk = 2.0F;
inline constexpr float sphere = 3.0F;
inline constexpr float tube = 4.0F;
}  // namespace packed_kind

/// Lights as the shader reads them, light_texels vec4 each, directional ones first, those with a
/// size last: (position, 1/range^2), (color * intensity, cone scale), (direction, cone offset), and
/// for those with a size (half axis, kind), (half axis, 0): of the rectangle,
/// the disk or the tube; a ball has its radius in the second, and a lamp with a profile has its
/// axes x and y there and, as its kind, 1 and which of `profiles` it is. The kind of an
/// environment's sun is -1.
struct PackedLights {
    std::vector<math::Vec4> texels;
    std::vector<std::size_t> order;    ///< which of the lights each is
    std::vector<scene::Light> lights;  ///< each
    std::uint32_t directional_count = 0;
    std::uint32_t count = 0;
    std::uint32_t area_count = 0;  ///< of them have a size
    std::vector<float> profiles;   ///< scene::LightProfile::shares, one after the other
};
/// `with_rays` lights with a size are left to them; so are
/// those that stand in for a mesh, which is then a light itself.
[[nodiscard]] PackedLights pack_lights(std::span<const scene::Light> lights, bool with_rays);

/// A list a tile, row by row from the bottom left.
struct LightLists {
    std::uint32_t tiles_across = 0;
    std::vector<std::uint32_t> tiles;    ///< pairs: first in `indices`; count of those without a
                                         ///< size, and above 16 bits of those with one
    std::vector<std::uint16_t> indices;  ///< of PackedLights

    [[nodiscard]] std::span<const std::uint16_t> of_tile(std::size_t tile) const {
        const std::uint32_t counts = tiles[2 * tile + 1];
        return std::span(indices).subspan(tiles[2 * tile], (counts & 0xFFFFU) + (counts >> 16U));
    }
};

/// Tiles are looked at in cells of this many pixels: a tile on an edge sees two places, and not
/// what lies between.
inline constexpr std::uint32_t cell_px = 4;

/// Nearest and farthest surface of a picture, in window depth [0, 1], by cell; empty ones have far
/// < near.
struct CellDepths {
    std::vector<float> near;
    std::vector<float> far;
};
/// `depth` is [height, width] from the bottom.
[[nodiscard]] CellDepths cell_depths(std::span<const float> depth, math::Extent size);

/// A light is in a tile's list when its sphere touches the box around what is seen through one of
/// the tile's cells; lights without range are in all. `depths` may be null: the whole depth is
/// taken. Deterministic, index order.
[[nodiscard]] LightLists build_light_lists(const PackedLights& lights,
                                           const math::Mat4& clip_from_world, math::Extent size,
                                           const CellDepths* depths);

}  // namespace facet::frame
