// Triangles split until their edges are short, without cracks.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace facet::scene {

/// Halves edges that are longer than `longest`, again and again, and splits triangles at the
/// middles. `at` has a place for each vertex, in whose plane edges are measured, and gets those of
/// the vertices that are added. Edges between the same two places in space are halved together,
/// whatever the coordinates at their ends. For each vertex the number of its place in space:
/// vertices at the same one share it. Edges whose length is not finite stay, and all edges from
/// `enough` triangles on.
std::vector<std::uint32_t> split_edges(Mesh& mesh, std::vector<Vec2>& at, float longest,
                                       std::size_t enough);

/// About how many triangles that makes, without an end.
[[nodiscard]] double split_count(const Mesh& mesh, const std::vector<Vec2>& at, float longest);

}  // namespace facet::scene
