// Values of a scene by path: what --set says.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"
#include "scene/scene.h"

#include <string>

namespace facet::scene {

/// Applies `PATH=VALUE` to the scene. Paths: `material.NAME.KEY` (every material of that name; NAME
/// may hold dots), `material.*.KEY` (all), `material[3].KEY` (by index), and the same for `light`.
/// Keys of materials are those of tables/material.def, and of tables/material_textures.def: `none`
/// drops the texture, anything else is a picture file in its place (within `limits`; added to the
/// scene's images, once a file); keys of lights are those of tables/light_kinds.def.
/// Errors: usage (unknown path, with the nearest right ones and what there is; a value out of its
/// range, with the range); the scene is then as it was.
[[nodiscard]] base::Status apply_set(Scene& scene, const std::string& assignment,
                                     const base::Limits& limits = {});

}  // namespace facet::scene
