// What a material's dielectric reflects and absorbs: KHR_materials_ior, specular and volume.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

namespace facet::scene {

/// Whether it is other than glTF's plain one, F0 0.04 at full strength.
[[nodiscard]] bool has_specular(const Material& material);

/// Reflectance at normal incidence before textures, ((ior - 1) / (ior + 1))^2 specular_color:
/// linear Rec.709, from 0, and above 1 where the textures are to end it.
[[nodiscard]] Vec3 dielectric_f0(const tables::MaterialValues& values);

/// What a volume takes of light on its way, Beer-Lambert's coefficient: -ln(attenuation_color) /
/// attenuation_distance_m, each channel from 0; 0 without a distance. KHR_materials_volume.
[[nodiscard]] Vec3 extinction_per_m(const tables::MaterialValues& values);
/// Share of that which is scattered, by channel, [0, 1): what makes scatter_color of light that is
/// scattered again and again. KHR_materials_volume_scatter; Kulla & Conty 2017, "Revisiting
/// Physically Based Shading at Imageworks", p. 12.
[[nodiscard]] Vec3 scattered_share(const tables::MaterialValues& values);

}  // namespace facet::scene
