// Light apart by the way it took.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

#include <array>

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

    void scale(const math::Vec3& factor) {
        for (math::Vec3 LightPaths::*way : ways) this->*way *= factor;
    }
    void add(const LightPaths& other) {
        for (math::Vec3 LightPaths::*way : ways) this->*way += other.*way;
    }
    /// Light that the first surface sends on, of which its diffuse lobe has `share`, by channel.
    void add_direct(const math::Vec3& nit, const math::Vec3& share) {
        diffuse_direct += nit * share;
        specular_direct += nit - nit * share;
    }
    void add_indirect(const math::Vec3& nit, const math::Vec3& share) {
        diffuse_indirect += nit * share;
        specular_indirect += nit - nit * share;
    }

private:
    static const std::array<math::Vec3 LightPaths::*, 6> ways;
};
inline constexpr std::array<math::Vec3 LightPaths::*, 6> LightPaths::ways = {
    &LightPaths::diffuse_direct,    &LightPaths::diffuse_indirect, &LightPaths::specular_direct,
    &LightPaths::specular_indirect, &LightPaths::emission,         &LightPaths::background};

}  // namespace facet::trace
