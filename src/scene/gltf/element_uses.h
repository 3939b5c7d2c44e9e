// Checks of the numbers in the buffers by what they are used for.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/asset.h"
#include "scene/gltf/problems.h"

#include <set>
#include <string>

namespace facet::scene::gltf {

/// The accessor that `index` names, where it has elements to look at.
[[nodiscard]] const Accessor* sound_accessor(const Asset& asset, const Json* index);

/// How many problems of one kind are told of one place.
inline constexpr std::size_t most_told = 3;
/// Of the validator, which allows for 8-bit normals.
inline constexpr double unit_tolerance = 0.00769;

/// What was looked at already: primitives may share accessors without end.
using Done = std::set<std::string>;

/// Joints and weights of the primitive at `where`.
void check_influences(const Asset& asset, const Json& primitive, std::size_t joint_count,
                      const std::string& where, Problems& problems, Done& done);
/// Indices, unit vectors, colors, joints and weights of every primitive.
void check_primitive_elements(const Asset& asset, Problems& problems);
/// Last rows of inverse bind matrices.
void check_bind_matrices(const Asset& asset, Problems& problems);
/// Times that increase, rotations of length 1.
void check_keyframes(const Asset& asset, Problems& problems);

}  // namespace facet::scene::gltf
