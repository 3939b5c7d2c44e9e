// The images that materials use, as GL textures with mips.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/upload/gpu_scene.h"

namespace facet::frame {

/// Uploads what `scene` uses and `out.textures` does not have yet.
[[nodiscard]] base::Status upload_textures(const gl::Context& gl, const scene::Scene& scene,
                                           base::ThreadPool& pool, GpuScene& out);

}  // namespace facet::frame
