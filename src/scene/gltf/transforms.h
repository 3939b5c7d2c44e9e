// The nodes of a glTF model and how they hang together.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/import.h"

#include <cstdint>
#include <vector>

namespace facet::scene::gltf {

/// Nodes of the rig, their order, and those that are to be seen: visible ones of the scene shown,
/// parents before children. Errors: limit_reached below limits.node_depth.
[[nodiscard]] base::Result<std::vector<std::uint32_t>> read_rig_nodes(Import& import,
                                                                      const std::vector<int>& roots,
                                                                      Rig& rig);

}  // namespace facet::scene::gltf
