// The photo studio and the overcast sky.
// SPDX-License-Identifier: MIT
#include "scene/environment_models.h"

#include <algorithm>
#include <cmath>

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
    float falloff;  ///< how much darker its rim is than its middle, where the lamp sits behind the
                    ///< cloth
};

/// Key upper left of a camera at azimuth 35, fill on its right, a rim strip behind, cloth overhead.
constexpr Softbox softboxes[] = {
    {-28.0F, 42.0F, 27.0F, 20.0F, 9.0F, {1.0F, 0.985F, 0.96F}, 0.35F},
    {112.0F, 18.0F, 16.0F, 30.0F, 2.6F, {0.95F, 0.975F, 1.0F}, 0.25F},
    {202.0F, 30.0F, 7.0F, 34.0F, 7.0F, {1.0F, 1.0F, 1.0F}, 0.2F},
    {-120.0F, 22.0F, 9.0F, 28.0F, 3.0F, {0.96F, 0.98F, 1.0F}, 0.2F},
    {35.0F, 86.0F, 36.0F, 24.0F, 2.2F, {1.0F, 1.0F, 1.0F}, 0.4F},
};

// A box ends softly between these shares of its half size, over about a degree: a mirror shows a
// clean shape.
constexpr float edge_outer = 1.03F;
constexpr float edge_inner = 0.94F;

}  // namespace

Studio::Studio() {
    for (const Softbox& box : softboxes) {
        const Vec3 forward = math::direction_from(box.azimuth_deg, box.elevation_deg);
        const Vec3 right = math::direction_from(box.azimuth_deg + 90.0F, 0.0F);
        boxes_.push_back(
            {.forward = forward,
             .right = right / std::tan(glm::radians(box.half_width_deg)),
             .up = math::cross(forward, right) / std::tan(glm::radians(box.half_height_deg)),
             .radiance_nit = box.tint * box.radiance_nit,
             .falloff = box.falloff});
    }
}

Vec3 Studio::room(float y) {
    // A pale floor: brightest where floor and wall meet the light, darker towards the ceiling.
    const float floor = smooth(0.12F, -0.55F, y);
    const float ceiling = smooth(0.2F, 0.95F, y);
    const float wall = 0.52F - 0.2F * ceiling + 0.1F * std::exp(-20.0F * y * y);
    return Vec3(0.97F, 0.985F, 1.0F) * (wall * (1.0F - floor)) +
           Vec3(1.0F, 0.99F, 0.975F) * (0.42F * floor);
}

Vec3 Studio::boxes(const Vec3& d) const {
    Vec3 radiance(0.0F);
    for (const Box& box : boxes_) {
        const float depth = math::dot(d, box.forward);
        // The box's plane has gnomonic coordinates, which keep its edges straight; most pixels are
        // outside.
        const float across = std::fabs(math::dot(d, box.right));
        const float along = std::fabs(math::dot(d, box.up));
        if (std::max(across, along) >= edge_outer * depth) continue;
        const float x = across / depth;
        const float y = along / depth;
        const float inside = smooth(edge_outer, edge_inner, x) * smooth(edge_outer, edge_inner, y);
        const float middle = 1.0F - box.falloff * std::min(1.0F, 0.5F * (x * x + y * y));
        radiance += box.radiance_nit * (inside * middle);
    }
    return radiance;
}

Vec3 overcast_radiance(float y) {
    constexpr float ground_albedo = 0.2F;
    // The horizontal illuminance of this sky is 7 pi / 9 times the zenith's luminance.
    if (y < 0.0F) return Vec3(ground_albedo * 7.0F / 9.0F);
    return Vec3((1.0F + 2.0F * y) / 3.0F);
}

}  // namespace facet::scene
