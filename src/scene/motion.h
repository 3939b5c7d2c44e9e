// A camera that moves while its shutter is open.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "scene/scene.h"

#include <string>

namespace facet::scene {

/// `KEY=VALUE,...`: `move=X Y Z` in metres as the camera sees it (right, up, back), `turn=DEG` to
/// the left, `orbit=DEG` around `pivot_m`; what it moves by from the opening of the shutter to its
/// closing. Errors: usage.
[[nodiscard]] base::Result<CameraMotion> parse_motion(const std::string& text, const Vec3& pivot_m);

/// Where it is at `time` in [0, 1] of that; at 1/2 where the camera itself stands.
[[nodiscard]] Camera camera_at(const Camera& camera, float time);
[[nodiscard]] bool moves(const Camera& camera);

}  // namespace facet::scene
