// What `load` makes of the validator's verdicts: an error, a warning, or nothing to speak of.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/problems.h"

namespace facet::scene::gltf {

enum class Verdict { error, warning, silent };

[[nodiscard]] Verdict verdict_of(const Problem& problem);

}  // namespace facet::scene::gltf
