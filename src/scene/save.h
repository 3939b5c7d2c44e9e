// Saving a scene: what was edited goes back into the file it came from, and nothing else changes.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/load.h"

#include <filesystem>
#include <string>
#include <vector>

namespace facet::scene {

/// What is saved where. `original` is `source` as load() gave it; `edited` is the same with other
/// materials, textures and lights.
struct SaveRequest {
    std::string source;  ///< a path, or "builtin:NAME"
    const Scene& original;
    const Scene& edited;
    std::filesystem::path target;  ///< .gltf or .glb
    LoadOptions options;           ///< what `source` may read
};

struct Saved {
    base::Warnings warnings;
    std::vector<std::filesystem::path> files;  ///< written, the scene last
};

/// Writes the document of `source` with what differs between the two scenes: numbers of
/// tables/material.def at their glTF pointers, textures dropped or replaced, lights changed, added
/// and removed (KHR_lights_punctual; kinds that it lacks are left out with a warning). Keys,
/// extensions, extras and buffers stay as they are, in their order. A .gltf in another folder takes
/// the files that it names along; .gltf to .glb packs them. Each file is written beside its place
/// and renamed, the scene's last. Errors: those of reading `source` again, usage (an ending that is
/// neither), those of base::write_file_atomically.
[[nodiscard]] base::Result<Saved> save(const SaveRequest& request, const base::Limits& limits);

}  // namespace facet::scene
