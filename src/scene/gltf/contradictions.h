// What a material says in vain.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/import.h"

namespace facet::scene::gltf {

/// Warns of properties of the material `json` at `where` that no picture shows because of others,
/// as far as the checks say nothing of them: the validator that they follow does not.
void warn_of_contradictions(Import& import, const Json& json, const std::string& where);

}  // namespace facet::scene::gltf
