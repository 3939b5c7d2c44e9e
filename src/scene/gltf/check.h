// The checks of a glTF document, one file a group of objects; `load` and `check` run the same ones.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "scene/gltf/asset.h"
#include "scene/gltf/problems.h"

namespace facet::scene::gltf {

/// What `check` looks at and `load` need not, as it looks when it reads them, or does not mind.
enum class Depth {
    structure,  ///< the document, and that everything lies within its buffers
    elements,   ///< the numbers in the buffers and the headers of the images as well
};

/// Fills the asset's tables and adds every problem.
void check_asset(Asset& asset, Depth depth, const base::Limits& limits, Problems& problems);

void check_version(const Json& json, Problems& problems);
void check_extension_lists(const Json& json, Problems& problems);
void check_buffer_use(const Asset& asset, Problems& problems);
void check_accessor_uses(const Asset& asset, Problems& problems);
void check_meshes(const Asset& asset, Problems& problems);
void check_nodes(const Asset& asset, Problems& problems);
void check_skins(const Asset& asset, Problems& problems);
void check_animations(const Asset& asset, Problems& problems);
void check_cameras(const Asset& asset, Problems& problems);
void check_materials(const Asset& asset, Problems& problems);
void check_images(Asset& asset, Depth depth, const base::Limits& limits, Problems& problems);
void check_elements(const Asset& asset, Problems& problems);

}  // namespace facet::scene::gltf
