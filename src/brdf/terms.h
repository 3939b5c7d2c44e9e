// Every BRDF term of glsl/brdf as C++, in float or double: the same text that the shaders compile.
// SPDX-License-Identifier: MIT
#pragma once

#include "tables/brdf_terms.h"

#include <glm/glm.hpp>

#include <cmath>

namespace facet::brdf {

/// The terms (d_ggx, f_schlick, ...), the model (brdf_view, brdf_light, brdf_environment), and the
/// slots that a choice fills. Cheap to copy; not const, as GLSL's functions are not.
template <class Real>
struct Terms {
    tables::BrdfChoice choice{};
#include "brdf/prelude.h"

    /// False: the lecture's model, F0 mixed first. With fresnel=none each lobe stands alone,
    /// uncompensated.
    bool slot_conserves() {
        return choice.multiscatter != tables::Multiscatter::off && slot_has_fresnel();
    }
    bool slot_has_fresnel() { return choice.fresnel != tables::Fresnel::none; }

#include "brdf/slots_dispatch.inl"
#include "generated/brdf_terms.inl"
};

}  // namespace facet::brdf
