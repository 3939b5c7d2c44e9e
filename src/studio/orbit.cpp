// The view as a person turns it.
// SPDX-License-Identifier: MIT
#include "studio/orbit.h"

#include "studio/document.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

namespace facet::studio {
namespace {

constexpr float degrees_per_px = 0.4F;
constexpr float nearer_per_step = 0.88F;
constexpr float margin = 1.15F;
constexpr float least_distance_m = 1e-5F;
constexpr float most_distance_m = 1e8F;

float rounded(float value, float step) { return std::round(value / step) * step; }

}  // namespace

math::Vec3 Orbit::right() const {
    // The horizontal right of the azimuth, which exists at the poles too.
    const float a = azimuth_deg * math::pi / 180.0F;
    return {std::cos(a), 0.0F, -std::sin(a)};
}

Orbit orbit_of(const scene::Camera& camera, const math::Bounds& bounds) {
    const math::Vec3 eye(camera.world_from_view[3]);
    const math::Vec3 back = math::normalize(math::Vec3(camera.world_from_view[2]));
    Orbit orbit;
    orbit.azimuth_deg = std::atan2(back.x, back.z) * 180.0F / math::pi;
    orbit.elevation_deg = std::asin(std::clamp(back.y, -1.0F, 1.0F)) * 180.0F / math::pi;
    const float along = math::dot(eye - bounds.center(), back);
    const float size = std::max(bounds.diagonal(), least_distance_m);
    orbit.distance_m = along > 0.05F * size ? along : size;
    orbit.target_m = eye - back * orbit.distance_m;
    return orbit;
}

std::string camera_text(const Orbit& orbit) {
    return fmt::format("orbit:azimuth={},elevation={},distance={},target={}",
                       number_text(orbit.azimuth_deg), number_text(orbit.elevation_deg),
                       number_text(orbit.distance_m), vector_text(orbit.target_m));
}

void turn(Orbit& orbit, math::Vec2 by_px) {
    const float turned = orbit.azimuth_deg - by_px.x * degrees_per_px;
    orbit.azimuth_deg = rounded(std::remainder(turned, 360.0F), 0.1F);
    orbit.elevation_deg =
        rounded(std::clamp(orbit.elevation_deg + by_px.y * degrees_per_px, -90.0F, 90.0F), 0.1F);
}

void pan(Orbit& orbit, math::Vec2 by_px, float height_px, float fov_rad) {
    const float metres_per_px = 2.0F * std::tan(0.5F * fov_rad) * orbit.distance_m / height_px;
    orbit.target_m += (orbit.up() * by_px.y - orbit.right() * by_px.x) * metres_per_px;
}

void zoom(Orbit& orbit, float steps) {
    orbit.distance_m = std::clamp(orbit.distance_m * std::pow(nearer_per_step, steps),
                                  least_distance_m, most_distance_m);
}

void fly(Orbit& orbit, const math::Vec3& by_m) {
    orbit.target_m += orbit.right() * by_m.x + orbit.up() * by_m.y - orbit.back() * by_m.z;
}

void frame(Orbit& orbit, const math::Bounds& bounds, float fov_rad, float aspect) {
    if (bounds.is_empty()) return;
    orbit.target_m = bounds.center();
    // The ball around the bounds in the narrower of both angles.
    const float half = std::atan(std::tan(0.5F * fov_rad) * std::min(1.0F, aspect));
    const float radius = std::max(0.5F * bounds.diagonal(), least_distance_m);
    orbit.distance_m =
        std::clamp(margin * radius / std::sin(half), least_distance_m, most_distance_m);
}

}  // namespace facet::studio
