// KHR_materials_pbrSpecularGlossiness as metallic-roughness.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/json.h"
#include "tables/material.h"

namespace facet::scene::gltf {

/// Sets base color, opacity, metallic and roughness from the extension's factors. Lossy where the
/// specular color of a dielectric is tinted. Source: the conversion of the extension's own text
/// (Khronos, KHR_materials_pbrSpecularGlossiness, "Appendix").
void apply_specular_glossiness(const Json& extension, tables::MaterialValues& values);

}  // namespace facet::scene::gltf
