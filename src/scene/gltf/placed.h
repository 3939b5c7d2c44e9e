// Cameras and lights at the nodes they hang on.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/import.h"

#include <cstdint>

namespace facet::scene::gltf {

void place_camera(Import& import, std::uint32_t node, const Mat4& world_from_node);
/// Nothing where the node has no KHR_lights_punctual light.
void place_light(Import& import, std::uint32_t node, const Mat4& world_from_node);

}  // namespace facet::scene::gltf
