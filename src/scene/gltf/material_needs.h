// What a material asks of the primitives that wear it: texture coordinates and tangents.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/json.h"
#include "scene/gltf/problems.h"

#include <string>

namespace facet::scene::gltf {

/// The primitive at `where` against its material, and its KHR_materials_variants mappings.
void check_material_needs(const Json& json, const Json& primitive, const std::string& where,
                          Problems& problems);

}  // namespace facet::scene::gltf
