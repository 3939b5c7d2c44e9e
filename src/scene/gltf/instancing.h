// EXT_mesh_gpu_instancing: many copies of one node's mesh.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/import.h"

#include <cstdint>
#include <vector>

namespace facet::scene::gltf {

/// node_from_copy of every copy; empty where the node does not use the extension.
[[nodiscard]] base::Result<std::vector<Mat4>> read_instances(const Import& import,
                                                             std::uint32_t node);

}  // namespace facet::scene::gltf
