// The reflection of a material's dielectric: KHR_materials_ior and KHR_materials_specular.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

namespace facet::scene {

/// Whether it is other than glTF's plain one, F0 0.04 at full strength.
[[nodiscard]] bool has_specular(const Material& material);

/// Reflectance at normal incidence before textures, ((ior - 1) / (ior + 1))^2 specular_color:
/// linear Rec.709, from 0, and above 1 where the textures are to end it.
[[nodiscard]] Vec3 dielectric_f0(const tables::MaterialValues& values);

}  // namespace facet::scene
