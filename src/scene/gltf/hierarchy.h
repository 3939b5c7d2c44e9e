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

/// Reads the children of all nodes; those that do not exist are left out. Nodes with two parents
/// are added to `problems` where it is given.
[[nodiscard]] Hierarchy read_hierarchy(const Json& json, Problems* problems);

}  // namespace facet::scene::gltf
