// Meshes as one vertex buffer of 48-byte vertices and one index buffer.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/upload/gpu_scene.h"

#include <vector>

namespace facet::frame {

/// Where a mesh lies in the buffers.
struct MeshRange {
    GLint base_vertex = 0;
    std::size_t first_index = 0;
    GLsizei index_count = 0;
};

/// Fills `vertices`, `indices` and `vertex_array` of `out`; a range a mesh.
[[nodiscard]] std::vector<MeshRange> upload_meshes(const gl::Context& gl, const scene::Scene& scene,
                                                   base::ThreadPool& pool, GpuScene& out);

}  // namespace facet::frame
