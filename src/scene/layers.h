// What a material has over its base: KHR_materials_clearcoat and KHR_materials_sheen.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

namespace facet::scene {

[[nodiscard]] inline bool has_clearcoat(const Material& material) {
    return material.values.clearcoat > 0.0F;
}
[[nodiscard]] inline bool has_sheen(const Material& material) {
    return material.values.sheen_color != Vec3(0.0F);
}
[[nodiscard]] inline bool has_layers(const Material& material) {
    return has_clearcoat(material) || has_sheen(material);
}

}  // namespace facet::scene
