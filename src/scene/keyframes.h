// Values between keyframes.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/rig.h"

#include <span>

namespace facet::scene {

/// The value at a time, `out` of keyframes.width floats: before the first key that of the first,
/// after the last that of the last. Source: glTF 2.0, appendix C.
void sample(const Keyframes& keyframes, double time_s, std::span<float> out);
/// The same of rotations x y z w: on the shortest arc, of length 1.
[[nodiscard]] math::Quat sample_rotation(const Keyframes& keyframes, double time_s);

}  // namespace facet::scene
