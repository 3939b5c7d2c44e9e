// Which parts of the BRDF a material has: tables/lobes.def.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

namespace facet::scene {

/// Whether its factor, whatever the textures make of it, is other than nothing; of `specular`:
/// whether the dielectric reflects otherwise than glTF's plain one.
[[nodiscard]] bool has_lobe(const Material& material, tables::Lobe lobe);
/// Whether it has one of those that the G-buffer does not hold.
[[nodiscard]] bool has_layers(const Material& material);
/// Whether light reaches the viewer from its far side.
[[nodiscard]] inline bool is_translucent(const Material& material) {
    return material.values.transmission > 0.0F || material.values.diffuse_transmission > 0.0F;
}
/// Whether it encloses a volume that light goes into.
[[nodiscard]] inline bool has_volume(const Material& material) {
    return is_translucent(material) && material.values.thickness_m > 0.0F;
}

}  // namespace facet::scene
