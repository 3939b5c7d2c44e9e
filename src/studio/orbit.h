// The view as a person turns it: around a point, at a distance.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

#include <string>

namespace facet::studio {

struct Orbit {
    float azimuth_deg = 35.0F;
    float elevation_deg = 15.0F;
    float distance_m = 1.0F;
    math::Vec3 target_m{0.0F};

    [[nodiscard]] math::Vec3 back() const {
        return math::direction_from(azimuth_deg, elevation_deg);
    }
    [[nodiscard]] math::Vec3 right() const;
    [[nodiscard]] math::Vec3 up() const { return math::cross(back(), right()); }
};

/// The orbit that looks as `camera` does, but for a roll: around the point of its line of sight
/// that is nearest to the middle of `bounds`.
[[nodiscard]] Orbit orbit_of(const scene::Camera& camera, const math::Bounds& bounds);
/// What --camera takes.
[[nodiscard]] std::string camera_text(const Orbit& orbit);

/// Movements, by pixels of the mouse in a viewport `height_px` high under the vertical angle
/// `fov_rad`.
void turn(Orbit& orbit, math::Vec2 by_px);
void pan(Orbit& orbit, math::Vec2 by_px, float height_px, float fov_rad);
/// `steps` of the wheel; above 0 goes nearer.
void zoom(Orbit& orbit, float steps);
/// Through the scene: right, up, forward in metres.
void fly(Orbit& orbit, const math::Vec3& by_m);
/// Looks at all of `bounds` without turning.
void frame(Orbit& orbit, const math::Bounds& bounds, float fov_rad, float aspect);

}  // namespace facet::studio
