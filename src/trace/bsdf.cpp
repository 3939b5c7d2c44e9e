// How one surface point scatters light.
// SPDX-License-Identifier: MIT
#include "trace/bsdf.h"

#include "brdf/light_terms.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Vec2;
using math::Vec3;

/// Narrower lobes are mirrors: float's n.h resolves no half vector within them (1 - n.h comes in
/// steps of 6e-8, and D turns within alpha^2 / 2).
constexpr float mirror_alpha_max = 1e-3F;

}  // namespace

Model::Model(const tables::BrdfChoice& choice)
    : lights{choice},
      environment{choice},
      table(brdf::albedo_table(choice)),
      one_masking(choice.masking == choice.environment_masking),
      needs_e_l(choice.multiscatter == tables::Multiscatter::kulla_conty) {
    environment.choice.masking = choice.environment_masking;
}

Lobes::real4 Model::albedo(float n_dot_v, float roughness) const {
    Lobes terms;
    const auto size = static_cast<float>(table.size);
    const Vec2 at = terms.albedo_coordinates(n_dot_v, roughness) * size - 0.5F;
    const float x = std::clamp(at.x, 0.0F, size - 1.001F);
    const float y = std::clamp(at.y, 0.0F, size - 1.001F);
    const auto column = static_cast<std::size_t>(x);
    const auto row = static_cast<std::size_t>(y);
    const float across = x - static_cast<float>(column);
    const float down = y - static_cast<float>(row);
    const auto texel = [&](std::size_t r, std::size_t c) {
        const float* t = table.texels.data() + (r * table.size + c) * 4;
        return Lobes::real4(t[0], t[1], t[2], t[3]);
    };
    return (texel(row, column) * (1.0F - across) + texel(row, column + 1) * across) *
               (1.0F - down) +
           (texel(row + 1, column) * (1.0F - across) + texel(row + 1, column + 1) * across) * down;
}

Bsdf::Bsdf(const Model& model, const Surface& surface, const Vec3& to_eye, Draws draws)
    : model_(&model),
      to_eye_(to_eye),
      face_normal_(surface.face_normal),
      n_(surface.normal),
      is_white_(draws == Draws::white) {
    // A shading normal may turn away from the viewer: the view is bent to where the rasteriser
    // clamps the cosine.
    float n_dot_v = math::dot(n_, to_eye_);
    if (n_dot_v < n_dot_v_min) {
        to_eye_ = math::normalize(to_eye_ + n_ * (n_dot_v_min - n_dot_v));
        n_dot_v = std::max(math::dot(n_, to_eye_), n_dot_v_min);
    }
    n_dot_v = std::min(n_dot_v, 1.0F);
    Lobes terms = model.environment;
    x_ = brdf::LightTerms<float>{}.across(n_);
    y_ = math::cross(n_, x_);
    auto numbers = terms.brdf_surface(surface.base_color, surface.metallic, surface.roughness);
    numbers.dielectric_f0 = surface.dielectric_f0;
    numbers.specular = surface.specular;
    view_ = terms.brdf_view(numbers, n_dot_v, model.albedo(n_dot_v, surface.roughness));
    sampler_ = terms.brdf_sampler(view_, {math::dot(x_, to_eye_), math::dot(y_, to_eye_), n_dot_v});
    if (draws == Draws::specular) sampler_.specular = 1.0F;
    is_mirror_ = view_.surface.alpha < mirror_alpha_max;
}

Lobes::BrdfValue Bsdf::values(Lobes terms, const Cosines& at) const {
    float e_l = 1.0F;
    if (model_->needs_e_l) {
        const Lobes::real4 texel = model_->albedo(at.n_dot_l, view_.surface.roughness);
        e_l = texel.x + texel.y;
    }
    return terms.brdf_light(view_, at.n_dot_l, at.n_dot_h, at.v_dot_h, e_l);
}

bool Bsdf::cosines(const Vec3& to_light, Cosines& out) const {
    const float n_dot_l = math::dot(n_, to_light);
    if (n_dot_l <= 0.0F || math::dot(face_normal_, to_light) <= 0.0F) return false;
    const Vec3 sum = to_eye_ + to_light;
    const Vec3 h = sum / std::sqrt(std::max(math::dot(sum, sum), 1e-12F));
    out.n_dot_h = std::clamp(math::dot(n_, h), 0.0F, 1.0F);
    out.v_dot_h = std::clamp(math::dot(to_eye_, h), 0.0F, 1.0F);
    out.n_dot_l = std::min(n_dot_l, 1.0F);
    return true;
}

Scattered Bsdf::evaluate(const Vec3& to_light) const {
    Cosines at;
    if (!cosines(to_light, at)) return {};
    const float cosine = at.n_dot_l;
    if (is_white_) {
        const float pdf = Lobes{}.pdf_cosine(cosine);
        return {Vec3(pdf), Vec3(pdf), pdf};
    }
    const Lobes::BrdfValue lit = values(model_->lights, at);
    Scattered out;
    Lobes terms = model_->environment;
    if (is_mirror_) {
        out.of_light = lit.diffuse * cosine;
        out.of_environment = out.of_light;
        out.pdf = (1.0F - sampler_.specular) * terms.slot_pdf_diffuse(cosine);
        return out;
    }
    out.of_light = (lit.diffuse + lit.specular) * cosine;
    out.of_environment = out.of_light;
    if (!model_->one_masking) {
        const Lobes::BrdfValue around = values(terms, at);
        out.of_environment = (around.diffuse + around.specular) * cosine;
    }
    out.pdf = terms.brdf_pdf(view_, sampler_, cosine, at.n_dot_h, at.v_dot_h);
    return out;
}

Scattered Bsdf::evaluate_specular(const Vec3& to_light) const {
    Cosines at;
    if (is_mirror_ || !cosines(to_light, at)) return {};
    Lobes terms = model_->environment;
    return {Vec3(0.0F), values(terms, at).specular * at.n_dot_l,
            terms.brdf_pdf(view_, sampler_, at.n_dot_l, at.n_dot_h, at.v_dot_h)};
}

Bsdf::DiffuseShares Bsdf::diffuse_shares(const Vec3& to_light) const {
    Cosines at;
    if (!cosines(to_light, at)) return {};
    if (is_mirror_) return {Vec3(1.0F), Vec3(1.0F)};
    const auto share = [&](const Lobes& terms) {
        const Lobes::BrdfValue f = values(terms, at);
        constexpr float least = 1e-30F;
        return f.diffuse / glm::max(f.diffuse + f.specular, Vec3(least));
    };
    const Vec3 of_light = share(model_->lights);
    return {of_light, model_->one_masking ? of_light : share(model_->environment)};
}

Lobes::BrdfValue Bsdf::environment_weight() const {
    Lobes terms = model_->environment;
    return terms.brdf_environment(view_);
}

Bsdf::Sample Bsdf::sample(Vec2 u, float lobe) const {
    Lobes terms = model_->environment;
    Sample out;
    if (is_mirror_ && !is_white_ && lobe < sampler_.specular) {
        out.direction = n_ * (2.0F * math::dot(n_, to_eye_)) - to_eye_;
        out.is_mirror = true;
        out.is_valid = math::dot(face_normal_, out.direction) > 0.0F;
        const Vec3 share = terms.brdf_mirror(view_) / sampler_.specular;
        out.scattered = {share, share, 1.0F};
        return out;
    }
    const Vec3 local =
        is_white_ ? terms.sample_cosine(u) : terms.brdf_sample(view_, sampler_, u, lobe);
    if (local.z <= 0.0F) return out;
    out.direction = math::normalize(x_ * local.x + y_ * local.y + n_ * local.z);
    out.scattered = evaluate(out.direction);
    out.is_valid = out.scattered.pdf > 0.0F;
    return out;
}

}  // namespace facet::trace
