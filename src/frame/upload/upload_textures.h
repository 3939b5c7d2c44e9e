// The images that materials use, as GL textures with mips.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/upload/gpu_scene.h"

#include <map>
#include <utility>

namespace facet::frame {

/// Whether an image holds sRGB or linear numbers: one image can be used as both.
using TextureUse = std::pair<std::uint32_t, tables::Space>;

/// Uploads each use once, into `out.textures`; gives the index there.
[[nodiscard]] base::Result<std::map<TextureUse, std::size_t>> upload_textures(
    const gl::Context& gl, const scene::Scene& scene, base::ThreadPool& pool, GpuScene& out);

}  // namespace facet::frame
