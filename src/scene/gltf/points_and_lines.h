// Points and lines as thin bodies: what has no width in glTF gets one, a share of the scene's size.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/import.h"
#include "scene/gltf/mesh.h"

#include <cstdint>
#include <span>
#include <string>

namespace facet::scene::gltf {

/// Diameters as shares of the diagonal of all positions in the scene: about 3 and 6 pixels where
/// the scene fills a picture of 720 lines.
inline constexpr float line_width_share = 1.0F / 250.0F;
inline constexpr float point_width_share = 1.0F / 120.0F;

/// glTF's modes 0 to 3.
[[nodiscard]] constexpr bool draws_points(int mode) { return mode == TINYGLTF_MODE_POINTS; }
[[nodiscard]] constexpr bool draws_lines(int mode) {
    return mode == TINYGLTF_MODE_LINE || mode == TINYGLTF_MODE_LINE_LOOP ||
           mode == TINYGLTF_MODE_LINE_STRIP;
}

/// Fills import.line_scales, where the file has points or lines at all, from the nodes `shown`;
/// `world_from_node` is by node. Copies of EXT_mesh_gpu_instancing and poses of skins do not count.
void measure_lines(Import& import, std::span<const std::uint32_t> shown,
                   std::span<const Mat4> world_from_node);

/// Octahedra for points, tubes with four sides and pointed ends for lines: vertices with all that
/// their own had, morph targets too, triangles, and normals that lead outwards where there were
/// none. Errors: input_invalid (indices), limit_reached.
[[nodiscard]] base::Status thicken(Import& import, std::size_t mesh_index,
                                   const tinygltf::Primitive& primitive, const std::string& where,
                                   Shape& shape);

/// The same material, unlit: points and lines without normals show their colour alone (glTF 2.0,
/// section 3.9.7, "Point and Line Materials").
[[nodiscard]] MaterialId unlit_material(Import& import, MaterialId id);

}  // namespace facet::scene::gltf
