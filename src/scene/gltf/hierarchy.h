// Who is whose child among the nodes.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/json.h"
#include "scene/gltf/problems.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace facet::scene::gltf {

struct Hierarchy {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> parents;  ///< by node; none for a root
    std::vector<std::uint32_t> looped;   ///< nodes that are their own ancestors, sorted
};

/// Where each node of a hierarchy without loops stands: a node is above another, or is it, exactly
/// where its span holds the other's `enter`.
struct Placement {
    std::vector<std::uint32_t> roots;  ///< by node: the root above it
    std::vector<std::uint32_t> enter;  ///< by node: place in a walk from the roots
    std::vector<std::uint32_t> leave;  ///< by node: one past the last place below it
    std::vector<std::uint32_t> order;  ///< nodes in the order of `enter`: parents before children
};
[[nodiscard]] Placement place(const Hierarchy& hierarchy);

/// Reads the children of all nodes; those that do not exist are left out. Nodes with two parents
/// are added to `problems` where it is given.
[[nodiscard]] Hierarchy read_hierarchy(const Json& json, Problems* problems);

}  // namespace facet::scene::gltf
