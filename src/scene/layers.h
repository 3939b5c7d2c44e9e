// What a material has over its base: KHR_materials_clearcoat.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

namespace facet::scene {

/// Whether there is any lacquer.
[[nodiscard]] inline bool has_clearcoat(const Material& material) {
    return material.values.clearcoat > 0.0F;
}

}  // namespace facet::scene
