// The camera of glsl/camera as C++, in float or double: the same text that the shaders compile.
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace facet::brdf {

template <class Real>
struct CameraTerms {
#include "brdf/prelude.h"
#include "generated/camera_terms.inl"
};

}  // namespace facet::brdf
