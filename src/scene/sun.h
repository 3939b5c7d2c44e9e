// The sun of an environment: a small part of its picture that gives much of its light.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/environment.h"
#include "scene/scene.h"

#include <optional>

namespace facet::scene {

struct SplitEnvironment {
    Environment rest;          ///< the picture with the sun's place painted like what is around it
    std::optional<Light> sun;  ///< directional, as wide as the sun is there
};
/// Light from so small a place casts sharp shadows, and what is drawn from a picture at random
/// finds it seldom: it is better a light of its own. There is one where the brightest pixels lie
/// within 4 degrees and give a tenth of all light or more. Together both parts give what the whole
/// gave.
[[nodiscard]] SplitEnvironment split_sun(const Environment& environment);

/// The sun of an environment that is turned, and brighter.
[[nodiscard]] Light turned_sun(const Light& sun, float rotation_deg, float intensity);

}  // namespace facet::scene
