// Which corners of a mesh are one vertex, and which triangles meet at an edge.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace facet::scene::tangents {

inline constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// By vertex: the first vertex with equal position, normal and coordinate; itself where it is the
/// first.
[[nodiscard]] std::vector<std::uint32_t> weld_vertices(const Mesh& mesh,
                                                       const std::vector<Vec2>& uv);

/// By corner c: the corner where the same edge starts in the neighbouring triangle, which walks it
/// the other way round; `none` at a border. An edge of more than two triangles pairs them in order.
[[nodiscard]] std::vector<std::uint32_t> find_neighbors(const std::vector<std::uint32_t>& indices,
                                                        const std::vector<std::uint32_t>& weld);

}  // namespace facet::scene::tangents
