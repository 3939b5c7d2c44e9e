// A camera's thin lens.
// SPDX-License-Identifier: MIT
#include "scene/lens.h"

#include "brdf/camera_terms.h"

#include <cmath>
#include <limits>

namespace facet::scene {

float focal_length_m(float yfov_rad) { return 0.5F * sensor_height_m / std::tan(0.5F * yfov_rad); }

float lens_radius_m(float yfov_rad, float f_number) {
    return 0.5F * focal_length_m(yfov_rad) / f_number;
}

Vec2 place_on_lens(const Camera& camera, Vec2 u) {
    if (camera.blades >= 3) {
        // One of the triangles around the middle, and a place in it (Turk 1990).
        const auto corners = static_cast<float>(camera.blades);
        const float scaled = u.x * corners;
        const float blade = std::min(std::floor(scaled), corners - 1.0F);
        const float root = std::sqrt(scaled - blade);
        const auto corner = [&](float i) {
            const float angle = 2.0F * math::pi * i / corners;
            return Vec2(std::sin(angle), std::cos(angle));
        };
        return (corner(blade) * (root * (1.0F - u.y)) + corner(blade + 1.0F) * (root * u.y)) *
               camera.lens_radius_m;
    }
    const Vec2 p = u * 2.0F - 1.0F;
    if (p.x == 0.0F && p.y == 0.0F) return Vec2(0.0F);
    const bool wide = std::fabs(p.x) > std::fabs(p.y);
    const float r = wide ? p.x : p.y;
    const float angle =
        wide ? math::pi / 4.0F * (p.y / p.x) : math::pi / 2.0F - math::pi / 4.0F * (p.x / p.y);
    return Vec2(std::cos(angle), std::sin(angle)) * (r * camera.lens_radius_m);
}

Barrel wide_barrel() { return {.rim_m = std::numeric_limits<float>::max(), .shift_m = 0.0F}; }

Barrel tight_barrel(float yfov_rad, math::Extent size) {
    constexpr float open_f_number = 1.4F;
    constexpr float moved = 0.4F;
    const float rim = lens_radius_m(yfov_rad, open_f_number);
    const float half = std::tan(0.5F * yfov_rad);
    const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    return {rim, moved * 2.0F * rim / (half * std::hypot(1.0F, aspect))};
}

float vignetting(const Barrel& barrel, Vec2 tangent, Vec2 lens_m) {
    if (barrel.rim_m <= 0.0F) return 1.0F;
    brdf::CameraTerms<float> terms;
    return terms.natural_vignetting(tangent) *
           terms.mechanical_vignetting(tangent, lens_m, barrel.rim_m, barrel.shift_m);
}

double exposure_value(double f_number, double shutter_s, double iso) {
    return std::log2(f_number * f_number / shutter_s * 100.0 / iso);
}

}  // namespace facet::scene
