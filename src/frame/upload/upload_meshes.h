// Meshes as one vertex buffer of 48-byte vertices and one index buffer.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/upload/gpu_scene.h"

namespace facet::frame {

/// Fills `vertices`, `indices`, `vertex_array` and `mesh_ranges` of `out`.
void upload_meshes(const gl::Context& gl, const scene::Scene& scene, base::ThreadPool& pool,
                   GpuScene& out);

}  // namespace facet::frame
