// Picture files as textures of materials: what --set material.NAME.SLOT_texture=FILE says.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"
#include "scene/scene.h"

#include <cstddef>
#include <span>
#include <string>

namespace facet::scene {

/// Gives `materials` (indices) the picture `file` in `slot`, looked up as the texture before it
/// was. Meshes get tangents where a normal map needs them. Errors: those of reading the picture;
/// usage where no mesh of the materials has coordinates. On an error the scene is as it was.
[[nodiscard]] base::Status set_texture(Scene& scene, std::span<const std::size_t> materials,
                                       std::size_t slot, const std::string& file,
                                       const base::Limits& limits);

}  // namespace facet::scene
