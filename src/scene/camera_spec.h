// Cameras: what --camera says, framing a model, and the matrices of a view.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "math/vector.h"
#include "scene/scene.h"

#include <string>
#include <string_view>

namespace facet::scene {

/// Whether `spec` is `orbit` or `orbit:…`; a camera of the file may be named orbit1.
[[nodiscard]] bool is_orbit(std::string_view spec);

/// The camera that `spec` names: a camera's or its node's name, its index, `auto` (the file's first
/// camera, else framed on the model), or `orbit:azimuth=…,elevation=…,distance=…,target=x y z`
/// (degrees, metres); without a distance `fit=view` fits the box as it is seen, `fit=turn` at every
/// azimuth, `fit=sphere` the sphere around it. `fov_deg` above 0 replaces the vertical angle.
/// `size` is the picture's. Never gives a NaN, whatever the model's extent. Errors: usage (unknown
/// name or key, with what there is).
[[nodiscard]] base::Result<Camera> resolve_camera(const Scene& scene, const std::string& spec,
                                                  float fov_deg, math::Extent size);

/// The camera `auto` or `orbit:…` turned around the model by an angle; without a distance it keeps
/// the one that fits at every azimuth. Errors: usage (a camera of the file; as above).
[[nodiscard]] base::Result<std::string> turned_orbit(const std::string& spec, double degrees);

/// Depth of the middle of the scene's box; where that lies behind the eye, of a place before it.
[[nodiscard]] float middle_depth_m(const Camera& camera, const Scene& scene);
/// "perspective" or "orthographic": at the scene's middle both show the same.
void set_projection(Camera& camera, const Scene& scene, std::string_view projection);

[[nodiscard]] Mat4 view_from_world(const Camera& camera);
/// GL's clip space, depth -1..1. The vertical angle (or ymag) stays when the aspect differs from
/// the camera's. `jitter_px` moves the sample within its pixel: relative to the centre, y down.
[[nodiscard]] Mat4 clip_from_view(const Camera& camera, math::Extent size, Vec2 jitter_px);

}  // namespace facet::scene
