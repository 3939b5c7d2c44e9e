// The GLB container: its header and chunks, walked by ourselves before any library sees them.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/problems.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace facet::scene::gltf {

/// Views into the file.
struct GlbChunks {
    std::string_view json;
    std::optional<std::span<const std::byte>> bin;
};

[[nodiscard]] bool looks_like_glb(std::span<const std::byte> file);
/// Errors are added to `problems`; nothing comes back when the JSON chunk could not be found.
[[nodiscard]] std::optional<GlbChunks> split_glb(std::span<const std::byte> file,
                                                 Problems& problems);

}  // namespace facet::scene::gltf
