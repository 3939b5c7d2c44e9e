// The photo studio and the overcast sky.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "scene/environment_models.h"

namespace facet::scene {
namespace {

using math::Vec3;

float smooth(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

/// A rectangular light far away: where it hangs and how large it looks, in degrees.
struct Softbox {
    float azimuth_deg, elevation_deg;
    float half_width_deg, half_height_deg;
    float radiance_nit;
    Vec3 tint;
    float falloff;  ///< how much darker its rim is than its middle, where the lamp sits behind the cloth
};

/// Key upper left of a camera at azimuth 35, fill on its right, a rim strip behind, cloth overhead.
constexpr Softbox boxes[] = {
    {-28.0F, 42.0F, 27.0F, 20.0F, 9.0F, {1.0F, 0.985F, 0.96F}, 0.35F},
    {112.0F, 18.0F, 16.0F, 30.0F, 2.6F, {0.95F, 0.975F, 1.0F}, 0.25F},
    {202.0F, 30.0F, 7.0F, 34.0F, 7.0F, {1.0F, 1.0F, 1.0F}, 0.2F},
    {-120.0F, 22.0F, 9.0F, 28.0F, 3.0F, {0.96F, 0.98F, 1.0F}, 0.2F},
    {35.0F, 86.0F, 36.0F, 24.0F, 2.2F, {1.0F, 1.0F, 1.0F}, 0.4F},
};

Vec3 box_radiance(const Softbox& box, const Vec3& d) {
    const Vec3 forward = math::direction_from(box.azimuth_deg, box.elevation_deg);
    const float depth = math::dot(d, forward);
    if (depth <= 0.05F) return Vec3(0.0F);
    const Vec3 right = math::direction_from(box.azimuth_deg + 90.0F, 0.0F);
    const Vec3 up = math::cross(forward, right);
    // The box is flat: its plane's coordinates (a gnomonic projection) keep its edges straight.
    const float x = std::fabs(math::dot(d, right) / depth) / std::tan(glm::radians(box.half_width_deg));
    const float y = std::fabs(math::dot(d, up) / depth) / std::tan(glm::radians(box.half_height_deg));
    const float inside = smooth(1.03F, 0.94F, x) * smooth(1.03F, 0.94F, y);
    const float middle = 1.0F - box.falloff * std::min(1.0F, 0.5F * (x * x + y * y));
    return box.tint * (box.radiance_nit * inside * middle);
}

}  // namespace

Vec3 studio_radiance(const Vec3& d) {
    // A room with a pale floor: brightest where floor and wall meet the light, darker towards the ceiling.
    const float floor = smooth(0.12F, -0.55F, d.y);
    const float ceiling = smooth(0.2F, 0.95F, d.y);
    const float wall = 0.52F - 0.2F * ceiling + 0.1F * std::exp(-20.0F * d.y * d.y);
    Vec3 radiance = Vec3(0.97F, 0.985F, 1.0F) * wall;
    radiance = radiance * (1.0F - floor) + Vec3(1.0F, 0.99F, 0.975F) * (0.42F * floor);
    for (const Softbox& box : boxes) radiance += box_radiance(box, d);
    return radiance;
}

Vec3 overcast_radiance(const Vec3& d) {
    constexpr float ground_albedo = 0.2F;
    // The horizontal illuminance of this sky is 7 pi / 9 times the zenith's luminance.
    if (d.y < 0.0F) return Vec3(ground_albedo * 7.0F / 9.0F);
    return Vec3((1.0F + 2.0F * d.y) / 3.0F);
}

}  // namespace facet::scene
