// The lights of glsl/light as C++, in float or double: the same text that the shaders compile.
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace facet::brdf {

/// light_KIND gives illuminance or its share, sample_KIND, pdf_KIND and hit_KIND are for lights
/// with a size.
template <class Real>
struct LightTerms {
#include "brdf/prelude.h"
#include "generated/light_terms.inl"
};

}  // namespace facet::brdf
