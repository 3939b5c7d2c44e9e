// What shows behind a scene.
// SPDX-License-Identifier: MIT
#pragma once

#include "trace/path.h"

namespace facet::trace {

/// The environment as the camera sees it in that unit direction, blurred as World::blur asks.
[[nodiscard]] EnvironmentLight::Light backdrop(const World& world, const math::Vec3& direction,
                                               Sequence& sequence);

}  // namespace facet::trace
