// tinygltf behind a gate: it parses a document that was already checked, and opens nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "scene/gltf/asset.h"

#include <tiny_gltf.h>

namespace facet::scene::gltf {

/// The model of a checked asset. tinygltf sees its scenes, nodes, meshes, materials, textures,
/// samplers and cameras as text made from our own document. It never sees bytes: buffers, views,
/// accessors and images stay in the asset's tables, so none of its readers (files, base64, GLB
/// chunks, pictures) ever runs. Precondition: the checks found no error that `load` minds. Errors:
/// input_invalid with tinygltf's reason.
[[nodiscard]] base::Result<tinygltf::Model> parse_model(const Json& json);

}  // namespace facet::scene::gltf
