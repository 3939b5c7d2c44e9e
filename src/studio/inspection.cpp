// What is known of the pixel under the mouse.
// SPDX-License-Identifier: MIT
#include "studio/inspection.h"

#include "brdf/query.h"
#include "math/color.h"

#include <algorithm>
#include <cmath>

namespace facet::studio {
namespace {

/// F0 of the dielectric, as glsl/brdf/model has it.
constexpr double dielectric_f0 = 0.04;
/// The frame's shaders clamp so too (glsl/frame/lighting/shade.glsl).
constexpr float roughness_min = 0.05F;
constexpr float n_dot_v_min = 1e-3F;

Lobes lobes_of(brdf::Queries& queries, const brdf::QuerySurface& surface) {
    Lobes out;
    out.view_deg = static_cast<float>(-std::acos(surface.n_dot_v) * 180.0 / std::acos(-1.0));
    for (std::size_t i = 0; i < Lobes::count; ++i) {
        const double angle_deg = static_cast<double>(i) - 90.0;
        const double n_dot_l = std::max(1e-4, std::cos(angle_deg * std::acos(-1.0) / 180.0));
        const double phi_deg = angle_deg < 0.0 ? 0.0 : 180.0;
        const auto value = [&](brdf::QueryTerm term) {
            return static_cast<float>(queries.value(term, surface, n_dot_l, phi_deg));
        };
        out.specular[i] = value(brdf::QueryTerm::model_specular);
        out.diffuse[i] = value(brdf::QueryTerm::model_diffuse);
    }
    return out;
}

Energy energy_of(brdf::Queries& queries, const brdf::QuerySurface& surface) {
    const brdf::Reflectance shares = queries.reflectance(surface);
    return {static_cast<float>(shares.specular), static_cast<float>(shares.diffuse),
            static_cast<float>(std::max(0.0, 1.0 - shares.sum()))};
}

}  // namespace

PixelFacts facts_of(math::Vec2 at_px, std::vector<Probed> values, const math::Vec3& eye_m,
                    const tables::BrdfChoice& brdf) {
    PixelFacts out{.at_px = at_px};
    math::Vec3 normal(0.0F);
    math::Vec3 position_m(0.0F);
    for (const Probed& probed : values) {
        if (probed.aov == tables::Aov::albedo) out.albedo = probed.value;
        if (probed.aov == tables::Aov::normal) normal = probed.value;
        if (probed.aov == tables::Aov::position) position_m = probed.value;
        if (probed.aov == tables::Aov::roughness) out.roughness = probed.value.x;
        if (probed.aov == tables::Aov::metallic) out.metallic = probed.value.x;
        if (probed.aov == tables::Aov::material_id) out.is_background = probed.value.x == 0.0F;
    }
    out.values = std::move(values);
    if (out.is_background) return out;
    out.n_dot_v =
        std::clamp(math::dot(normal, math::normalize(eye_m - position_m)), n_dot_v_min, 1.0F);
    const brdf::QuerySurface surface{
        .roughness = static_cast<double>(std::max(out.roughness, roughness_min)),
        .metallic = static_cast<double>(out.metallic),
        .f0 = dielectric_f0,
        .base = static_cast<double>(math::luminance(out.albedo)),
        .n_dot_v = static_cast<double>(out.n_dot_v)};
    brdf::Queries queries(brdf);
    out.lobes = lobes_of(queries, surface);
    out.energy = energy_of(queries, surface);
    return out;
}

}  // namespace facet::studio
