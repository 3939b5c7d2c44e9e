// The structs that C++ and GLSL share, as C++ sees them.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

namespace facet::frame::shared {

using mat4 = glm::mat4;
using vec4 = glm::vec4;
using uvec4 = glm::uvec4;
#include "shared/draw.h"
#include "shared/explained.h"
#include "shared/view.h"

}  // namespace facet::frame::shared
