// Checks of the numbers in the buffers by what they are used for.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/asset.h"
#include "scene/gltf/problems.h"

namespace facet::scene::gltf {

/// Indices, unit vectors, colors, joints and weights of every primitive.
void check_primitive_elements(const Asset& asset, Problems& problems);
/// Last rows of inverse bind matrices.
void check_bind_matrices(const Asset& asset, Problems& problems);
/// Times that increase, rotations of length 1.
void check_keyframes(const Asset& asset, Problems& problems);

}  // namespace facet::scene::gltf
