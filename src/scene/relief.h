// Height maps: meshes whose surface stands out, for rasteriser and tracer alike.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace facet::scene {

/// A mesh in triangles that are fine enough for a height map, at no height yet.
struct FineMesh {
    Mesh mesh;
    std::vector<float> heights;  ///< of its vertices: the map's mean from one to the next, 0 to 1
    /// Of its vertices: those at one place share a number, and have one place at every height.
    std::vector<std::uint32_t> places;
    /// Of its vertices: those of a place that share a normal share a number, and have one normal at
    /// every height: edges that are hard stay so.
    std::vector<std::uint32_t> normal_groups;
};

/// What a mesh was made from that has a relief.
struct Relief {
    Mesh smooth;  ///< as it was before
    Texture map;
    std::shared_ptr<const image::Image> pixels;  ///< the map's
    float scale_m = 0.0F;                        ///< how far out 1 is
    float spacing_texels = 0.0F;                 ///< the longest edge of `fine`, on the map
    bool keeps_normals = false;                  ///< a normal map turns those of `smooth`
    std::shared_ptr<const FineMesh> fine;
};

/// All reliefs of a scene together have at most about so many triangles; where a map has more
/// texels, they are wider than those.
inline constexpr std::size_t most_relief_triangles = std::size_t{1} << 19U;

/// Gives each mesh the relief that its material's height map has now, and takes away what is not
/// there any more. A vertex moves along its normal; where several meet at a place they move
/// together, so that no crack opens. Normals follow the surface but under a normal map, which is
/// taken to be of the same relief: it turns those of the smooth mesh. Whether a mesh changed.
bool raise_reliefs(Scene& scene);
/// Makes a mesh smooth again. Whether it was not.
bool lower_relief(Mesh& mesh);

}  // namespace facet::scene
