// Where the nodes of a glTF model are.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/import.h"

#include <cstdint>
#include <vector>

namespace facet::scene::gltf {

/// By node index. Nodes that no root reaches keep the identity.
struct Transforms {
    std::vector<Mat4> world_from_node;
    std::vector<std::uint32_t>
        in_scene;  ///< visible nodes of the scene shown, parents before children
};

/// Errors: limit_reached below limits.node_depth, input_invalid on a cycle.
[[nodiscard]] base::Result<Transforms> place_nodes(Import& import, const std::vector<int>& roots);

}  // namespace facet::scene::gltf
