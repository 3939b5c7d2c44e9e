// Light through a surface.
// SPDX-License-Identifier: MIT
#include "trace/far_side.h"

#include "math/color.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {

namespace {

using math::Vec2;
using math::Vec3;

/// An index of 1 bends nothing, and no half vector tells where light comes from.
constexpr float ior_min = 1.001F;

/// Of a volume over what is around it.
float relative_ior(const Surface& surface) {
    const float ratio = std::max(surface.ior, ior_min) / surface.ior_around;
    return ratio < 1.0F ? std::min(ratio, 1.0F / ior_min) : std::max(ratio, ior_min);
}

}  // namespace

FarSide::FarSide(const Lobes& terms, const Surface& surface, float alpha, const ThinLobe& thin,
                 const Vec3& to_eye, const Vec3& left)
    : terms_(terms),
      to_eye_(to_eye),
      alpha_(surface.has_volume ? alpha : thin.alpha),
      has_volume_(surface.has_volume),
      is_smooth_(alpha_ < mirror_alpha_max),
      eta_(surface.front ? relative_ior(surface) : 1.0F / relative_ior(surface)),
      thin_(thin) {
    is_inside_ = has_volume_ && (!surface.front || eta_ < 1.0F);
    const float diffuse = 1.0F - surface.transmission;
    if (is_inside_) {
        const float through = surface.transmission * (1.0F - surface.metallic);
        // Of the boundary, not of what it lets through: else light at angles of total reflection
        // would go round in a ball for ever.
        diffuse_share_ =
            (1.0F - through) * surface.diffuse_transmission * (1.0F - surface.metallic);
        near_share_ = 1.0F - through - diffuse_share_;
        diffuse_ = surface.diffuse_transmission_color * diffuse_share_;
        diffuse_near_ = surface.base_color * near_share_;
        through_ = surface.base_color * through;
        return;
    }
    through_ = left * surface.base_color * surface.transmission;
    diffuse_ = left * surface.diffuse_transmission_color * (diffuse * surface.diffuse_transmission);
    const float of_through = math::luminance(through_);
    const float of_diffuse = math::luminance(diffuse_);
    diffuse_share_ = of_diffuse / std::max(of_through + of_diffuse, 1e-20F);
}

float FarSide::reflectance(float v_dot_h) const {
    return Lobes{}.f_dielectric(std::clamp(v_dot_h, 0.0F, 1.0F), eta_);
}

Vec3 FarSide::reflected(const Vec3& h) const {
    return h * (2.0F * math::dot(to_eye_, h)) - to_eye_;
}

FarSide::Value FarSide::value(const Vec3& to_light) const {
    Lobes terms = terms_;
    Value out;
    const bool is_above = to_light.z > 0.0F;
    const float cosine = std::fabs(to_light.z);
    const float of_lambert = terms.pdf_cosine(cosine);
    out.diffuse = (is_above ? diffuse_near_ : diffuse_) * of_lambert;
    out.pdf = (is_above ? near_share_ : diffuse_share_) * of_lambert;
    if (is_smooth_) return out;
    const float others = 1.0F - diffuse_share_ - near_share_;
    if (!has_volume_) {
        // The lobe that reflects, on the other side.
        const Vec3 sum = to_eye_ + Vec3(to_light.x, to_light.y, cosine);
        const Vec3 h = sum / std::max(math::length(sum), 1e-12F);
        const float v_dot_h = std::clamp(math::dot(to_eye_, h), 0.0F, 1.0F);
        const float n_dot_h = std::min(h.z, 1.0F);
        const float d_v = terms.slot_distribution(n_dot_h, alpha_) *
                          terms.slot_masking(to_eye_.z, cosine, thin_.roughness, alpha_);
        out.specular = through_ * (d_v * cosine / std::max(thin_.albedo, 1e-3F));
        out.pdf += others * terms.slot_pdf_reflected(to_eye_.z, n_dot_h, v_dot_h, alpha_);
        return out;
    }
    // What facets send to the wrong side is taken to come back about the surface.
    const Vec3 turned(to_light.x, to_light.y, -to_light.z);
    if (is_above) {  // within: the boundary's reflection
        const float density = density_reflected(to_light) + density_reflected(turned);
        out.specular = Vec3(others * density);
        out.pdf += others * density;
        return out;
    }
    const float density = density_through(to_light) + density_through(turned);
    out.specular = through_ * density;
    out.pdf += others * density;
    return out;
}

float FarSide::density_reflected(const Vec3& to_light) const {
    Lobes terms = terms_;
    const Vec3 sum = to_eye_ + to_light;
    const Vec3 h = sum / std::max(math::length(sum), 1e-12F);
    const float v_dot_h = math::dot(to_eye_, h);
    if (h.z <= 0.0F || v_dot_h <= 0.0F) return 0.0F;
    return reflectance(v_dot_h) * terms.slot_pdf_reflected(to_eye_.z, std::min(h.z, 1.0F),
                                                           std::min(v_dot_h, 1.0F), alpha_);
}

float FarSide::density_through(const Vec3& to_light) const {
    Lobes terms = terms_;
    const float density = terms.pdf_through(to_eye_, to_light, eta_, alpha_);
    if (!is_inside_ || density <= 0.0F) return density;
    return density *
           (1.0F - reflectance(math::dot(to_eye_, terms.half_through(to_eye_, to_light, eta_))));
}

FarSide::Sample FarSide::sample(Vec2 u, float lobe) const {
    Lobes terms = terms_;
    Sample out;
    const float diffuse = diffuse_share_ + near_share_;
    if (lobe < diffuse) {
        out.to_light = terms.sample_cosine(u);
        if (lobe < diffuse_share_) out.to_light.z = -out.to_light.z;
        return out;
    }
    const float others = 1.0F - diffuse;
    const float rest = (lobe - diffuse) / others;
    out.is_mirror = is_smooth_;
    out.share = through_ / others;
    const Vec3 h = is_smooth_ ? Vec3(0.0F, 0.0F, 1.0F) : terms.slot_sample_half(to_eye_, alpha_, u);
    if (!has_volume_) {
        out.is_straight = is_smooth_;
        out.to_light = is_smooth_ ? -to_eye_ : reflected(h);
        if (!is_smooth_) out.to_light.z = -out.to_light.z;
        if (out.to_light.z >= 0.0F) out.to_light = Vec3(0.0F);
        return out;
    }
    if (is_inside_ && rest < reflectance(math::dot(to_eye_, h))) {
        out.to_light = reflected(h);
        out.to_light.z = std::fabs(out.to_light.z);
        out.share = Vec3(1.0F);
        return out;
    }
    out.to_light = terms.refracted(to_eye_, h, eta_);
    out.to_light.z = -std::fabs(out.to_light.z);
    return out;
}

}  // namespace facet::trace
