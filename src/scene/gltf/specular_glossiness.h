// KHR_materials_pbrSpecularGlossiness: the lecture's other workflow.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/json.h"
#include "tables/material.h"

namespace facet::scene::gltf {

/// Sets the values that reflect as the extension's factors say: a dielectric of that diffuse colour
/// whose F0 is the specular colour (an index without end, tinted), roughness = 1 - glossiness.
/// Source: Khronos, KHR_materials_pbrSpecularGlossiness; KHR_materials_ior ("ior 0").
void apply_specular_glossiness(const Json& extension, tables::MaterialValues& values);

/// Where a parameter or a texture of such a material stands in the file, as the rows' `gltf` have
/// it for others; empty where the workflow has no such thing. Glossiness is 1 - roughness.
[[nodiscard]] std::string_view glossiness_pointer(std::string_view key);

}  // namespace facet::scene::gltf
