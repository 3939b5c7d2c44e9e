// The key light: the one light whose BRDF terms the AOVs show.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/environment.h"
#include "scene/scene.h"

#include <cstddef>
#include <optional>

namespace facet::scene {

/// Where the key light is, as both renderers take it.
struct KeyLight {
    /// xyz: its middle in metres where w is 1; the unit direction to it where w is 0.
    Vec4 place{0.0F, 1.0F, 0.0F, 0.0F};

    /// Unit, to the light; as glsl/frame/aov/aov.frag does it.
    [[nodiscard]] Vec3 direction_from(const Vec3& position_m) const;
};

/// What a key light is chosen from. Everything outlives the call.
struct KeyLightInputs {
    const Scene& scene;
    const Environment& environment;
    float env_rotation_deg = 0.0F;
    std::optional<std::size_t> named;  ///< the user's first light, an index of scene.lights
};

/// The light named; else the one that lights the middle of the scene's bounding box most, facing it
/// (the first of equals, none that gives nothing); else where the environment's light comes from.
[[nodiscard]] KeyLight key_light(const KeyLightInputs& inputs);

/// Lux that the light gives at `position_m`, at normal incidence; what has a size counts as a point
/// at its middle that shines by the cosine.
[[nodiscard]] float illuminance_lux(const Light& light, const Vec3& position_m);

/// Unit: the mean of all directions, each weighted with the luminance that comes from there (the
/// first order of its spherical harmonics). Straight up where light comes from everywhere alike.
[[nodiscard]] Vec3 dominant_direction(const Environment& environment, float rotation_deg);

}  // namespace facet::scene
