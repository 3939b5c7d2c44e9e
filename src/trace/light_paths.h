// Light apart by the way it took.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

namespace facet::trace {

/// Radiance in nit; what the rows of tables/aovs.def take their values from, named as in
/// glsl/frame/lighting/shade.glsl.
struct LightPaths {
    math::Vec3 diffuse_direct{0.0F};
    math::Vec3 diffuse_indirect{0.0F};
    math::Vec3 specular_direct{0.0F};
    math::Vec3 specular_indirect{0.0F};
    math::Vec3 emission{0.0F};
    math::Vec3 background{0.0F};

    /// Light that the first surface sends on, of which its diffuse lobe has `share`, by channel.
    void add_direct(const math::Vec3& nit, const math::Vec3& share) {
        diffuse_direct += nit * share;
        specular_direct += nit - nit * share;
    }
    void add_indirect(const math::Vec3& nit, const math::Vec3& share) {
        diffuse_indirect += nit * share;
        specular_indirect += nit - nit * share;
    }
};

}  // namespace facet::trace
