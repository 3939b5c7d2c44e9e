// How one surface point scatters light.
// SPDX-License-Identifier: MIT
#include "trace/bsdf.h"

#include "brdf/light_terms.h"
#include "brdf/sheen.h"
#include "math/bilinear.h"
#include "math/color.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Vec2;
using math::Vec3;

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
    const Vec2 size(static_cast<float>(table.size));
    return math::bilinear(terms.albedo_coordinates(n_dot_v, roughness), size,
                          [&](std::size_t row, std::size_t column) {
                              const float* t =
                                  table.texels.data() + (row * table.size + column) * 4;
                              return Lobes::real4(t[0], t[1], t[2], t[3]);
                          });
}

namespace {

Lobes::BrdfCoat coat_of(const Model& model, const Surface& surface, float n_dot_v) {
    Lobes terms = model.environment;
    const Lobes::real4 albedo = model.albedo(n_dot_v, surface.coat_roughness);
    return terms.brdf_coat(surface.coat, surface.coat_roughness, n_dot_v, albedo.x, albedo.y);
}

}  // namespace

float through_coat(const Model& model, const Surface& surface, const Vec3& to_eye) {
    if (surface.coat <= 0.0F) return 1.0F;
    const float n_dot_v = std::clamp(math::dot(surface.coat_normal, to_eye), n_dot_v_min, 1.0F);
    return 1.0F - coat_of(model, surface, n_dot_v).albedo;
}

LobeFrame::LobeFrame(const Vec3& axis, const Vec3& along)
    : x(along), y(math::cross(axis, along)), z(axis) {}
LobeFrame::LobeFrame(const Vec3& axis)
    : x(brdf::LightTerms<float>{}.across(axis)), y(math::cross(axis, x)), z(axis) {}

Bsdf::Bsdf(const Model& model, const Surface& surface, const Vec3& to_eye, Draws draws)
    : model_(&model),
      to_eye_(to_eye),
      face_normal_(surface.face_normal),
      frame_(surface.normal),
      is_white_(draws == Draws::white) {
    // A shading normal may turn away from the viewer: the view is bent to where the rasteriser
    // clamps the cosine.
    const Vec3& n = surface.normal;
    float n_dot_v = math::dot(n, to_eye_);
    if (n_dot_v < n_dot_v_min) {
        to_eye_ = math::normalize(to_eye_ + n * (n_dot_v_min - n_dot_v));
        n_dot_v = std::max(math::dot(n, to_eye_), n_dot_v_min);
    }
    n_dot_v = std::min(n_dot_v, 1.0F);
    Lobes terms = model.environment;
    auto numbers = terms.brdf_surface(surface.base_color, surface.metallic, surface.roughness);
    numbers.dielectric_f0 = surface.dielectric_f0;
    numbers.specular = surface.specular;
    numbers.diffuse = (1.0F - surface.transmission) * (1.0F - surface.diffuse_transmission);
    if (surface.has_ramp) {
        numbers.dielectric_f0 =
            terms.f0_of_reflectance(surface.reflected, numbers.dielectric_f0, n_dot_v);
        numbers.metal_f0 = terms.f0_of_reflectance(surface.reflected, numbers.metal_f0, n_dot_v);
    }
    if (surface.film > 0.0F) {
        const auto with_film = [&](const Vec3& f0) {
            return terms.thin_film_f0(f0, surface.film, surface.film_ior, surface.film_nm, n_dot_v);
        };
        numbers.dielectric_f0 = with_film(numbers.dielectric_f0);
        numbers.metal_f0 = with_film(numbers.metal_f0);
    }
    is_anisotropic_ = surface.anisotropy > 0.0F;
    Vec2 seen(n_dot_v, surface.roughness);
    if (is_anisotropic_) {
        frame_ = LobeFrame(n, surface.tangent);
        constexpr float narrowest = 2.0F * mirror_alpha_max;
        alpha_xy_ = terms.anisotropic_alpha(std::max(numbers.alpha, narrowest), surface.anisotropy);
        seen = terms.anisotropic_view(frame_.local(to_eye_), alpha_xy_);
    }
    view_ = terms.brdf_view(numbers, n_dot_v, model.albedo(seen.x, seen.y));
    local_eye_ = frame_.local(to_eye_);
    local_eye_.z = n_dot_v;
    if (surface.sheen_color != Vec3(0.0F)) set_sheen(surface);
    sampler_ = terms.brdf_sampler(weight_below(), local_eye_);
    if (draws == Draws::specular) sampler_.specular = 1.0F;
    is_mirror_ = view_.surface.alpha < mirror_alpha_max && !is_anisotropic_;
    if (surface.coat > 0.0F) set_coat(surface, draws);
    if (draws == Draws::all || draws == Draws::far) set_far(surface, draws);
}

void Bsdf::set_far(const Surface& surface, Draws draws) {
    if (surface.transmission <= 0.0F && surface.diffuse_transmission <= 0.0F) return;
    Lobes terms = model_->environment;
    const Vec3 left = terms.brdf_left(view_) * left_by_layers();
    ThinLobe thin{.roughness = surface.thin_roughness};
    if (!surface.has_volume && surface.transmission > 0.0F) {
        const Lobes::real4 albedo = model_->albedo(view_.n_dot_v, thin.roughness);
        thin.alpha = terms.slot_width(thin.roughness);
        thin.albedo = albedo.x + albedo.y;
    }
    far_.emplace(terms, surface, view_.surface.alpha, thin, local_eye_, left);
    const auto near = environment_weight();
    const float of_far = math::luminance(far_->weight());
    const float of_near = math::luminance(near.diffuse + near.specular);
    is_far_alone_ = draws == Draws::far || far_->is_inside();
    far_share_ = of_far / std::max(of_far + of_near, 1e-20F);
    constexpr float alone = 0.999F;
    is_far_alone_ = is_far_alone_ || far_share_ > alone;
    // A mirror's share has no other samples whose weights it could leave without bound.
    const float least = far_->is_smooth() ? 0.02F : Lobes::LOBE_SHARE_MIN;
    far_share_ = is_far_alone_ ? 1.0F : std::clamp(far_share_, least, 1.0F - least);
}

void Bsdf::set_sheen(const Surface& surface) {
    has_sheen_ = true;
    Lobes terms = model_->environment;
    sheen_ = terms.brdf_sheen(surface.sheen_color, surface.sheen_roughness,
                              brdf::sheen_albedo(view_.n_dot_v, surface.sheen_roughness));
}

Lobes::BrdfValue Bsdf::weight_below() const {
    Lobes terms = model_->environment;
    if (is_coat_alone_) return {};
    Lobes::BrdfValue weight = terms.brdf_environment(view_);
    if (has_sheen_) weight = terms.below_sheen(sheen_, weight, sheen_.albedo);
    return is_coated_ ? terms.below_coat(coat_, weight) : weight;
}

void Bsdf::set_coat(const Surface& surface, Draws draws) {
    is_coated_ = true;
    coat_frame_ = LobeFrame(surface.coat_normal);
    coat_to_eye_ = coat_frame_.local(to_eye_);
    coat_to_eye_.z = std::max(coat_to_eye_.z, n_dot_v_min);
    coat_to_eye_ = math::normalize(coat_to_eye_);
    coat_ = coat_of(*model_, surface, std::min(coat_to_eye_.z, 1.0F));
    is_coat_mirror_ = coat_.alpha < mirror_alpha_max;
    const Lobes::BrdfValue base = weight_below();
    Vec3 others = base.specular;
    if (draws != Draws::specular) others += base.diffuse;
    const float share = 3.0F * coat_.albedo /
                        std::max(3.0F * coat_.albedo + others.x + others.y + others.z, 1e-20F);
    coat_share_ = std::clamp(share, Lobes::LOBE_SHARE_MIN, 1.0F - Lobes::LOBE_SHARE_MIN);
    is_coat_alone_ = draws == Draws::coat;
    if (is_coat_alone_) coat_share_ = 1.0F;
}

Lobes::BrdfValue Bsdf::values(Lobes terms, const Cosines& at) const {
    float e_l = 1.0F;
    if (model_->needs_e_l) {
        const Lobes::real4 texel = model_->albedo(at.n_dot_l, view_.surface.roughness);
        e_l = texel.x + texel.y;
    }
    const float d_v = is_anisotropic_
                          ? terms.anisotropic_d_v(local_eye_, at.local_l, at.local_h, alpha_xy_)
                          : terms.brdf_d_v(view_, at.n_dot_l, at.n_dot_h);
    Lobes::BrdfValue value = terms.brdf_light_of(view_, d_v, at.n_dot_l, at.v_dot_h, e_l);
    if (is_mirror_) value.specular = Vec3(0.0F);
    if (has_sheen_)
        value = terms.below_sheen(sheen_, value,
                                  terms.sheen_light(sheen_, view_.n_dot_v, at.n_dot_l, at.n_dot_h));
    if (!is_coated_) return value;
    value = is_coat_alone_ ? Lobes::BrdfValue{} : terms.below_coat(coat_, value);
    if (!is_coat_mirror_ && at.coat_n_dot_l > 0.0F)
        value.specular +=
            Vec3(terms.coat_light(coat_, at.n_dot_l, at.coat_n_dot_l, at.coat_n_dot_h, at.v_dot_h));
    return value;
}

float Bsdf::base_pdf(const Cosines& at) const {
    Lobes terms = model_->environment;
    if (!is_mirror_ && !is_anisotropic_)
        return terms.brdf_pdf(view_, sampler_, at.n_dot_l, at.n_dot_h, at.v_dot_h);
    const float diffuse = (1.0F - sampler_.specular) * terms.slot_pdf_diffuse(at.n_dot_l);
    if (is_mirror_) return diffuse;
    return diffuse +
           sampler_.specular * terms.pdf_ggx_anisotropic(local_eye_, at.local_h, alpha_xy_);
}

float Bsdf::pdf(const Cosines& at) const {
    Lobes terms = model_->environment;
    const float base = (1.0F - far_share_) * base_pdf(at);
    if (!is_coated_) return base;
    const float coat = is_coat_mirror_ ? 0.0F
                                       : terms.slot_pdf_reflected(coat_to_eye_.z, at.coat_n_dot_h,
                                                                  at.v_dot_h, coat_.alpha);
    return (1.0F - far_share_) * coat_share_ * coat + (1.0F - coat_share_) * base;
}

bool Bsdf::cosines(const Vec3& to_light, Cosines& out) const {
    const float n_dot_l = math::dot(frame_.z, to_light);
    if (n_dot_l <= 0.0F || math::dot(face_normal_, to_light) <= 0.0F) return false;
    const Vec3 sum = to_eye_ + to_light;
    const Vec3 h = sum / std::sqrt(std::max(math::dot(sum, sum), 1e-12F));
    out.n_dot_h = std::clamp(math::dot(frame_.z, h), 0.0F, 1.0F);
    out.v_dot_h = std::clamp(math::dot(to_eye_, h), 0.0F, 1.0F);
    out.n_dot_l = std::min(n_dot_l, 1.0F);
    if (is_anisotropic_) {
        out.local_l = frame_.local(to_light);
        out.local_h = frame_.local(h);
    }
    if (is_coated_) {
        out.coat_n_dot_l = std::clamp(math::dot(coat_frame_.z, to_light), 0.0F, 1.0F);
        out.coat_n_dot_h = std::clamp(math::dot(coat_frame_.z, h), 0.0F, 1.0F);
    }
    return true;
}

FarSide::Value Bsdf::of_far(const Vec3& to_light) const {
    const Vec3 local = frame_.local(to_light);
    // Where the two normals disagree on which side the light is, none arrives.
    if (local.z * math::dot(face_normal_, to_light) <= 0.0F) return {};
    if (local.z > 0.0F && !far_->is_inside()) return {};
    FarSide::Value value = far_->value(local);
    value.pdf *= far_share_;
    return value;
}

Scattered Bsdf::evaluate(const Vec3& to_light) const {
    if (is_far(to_light)) {
        const FarSide::Value value = of_far(to_light);
        const Vec3 f = value.diffuse + value.specular;
        return {f, f, value.pdf};
    }
    Cosines at;
    if (is_far_alone_ || !cosines(to_light, at)) return {};
    const float cosine = at.n_dot_l;
    if (is_white_) {
        const float pdf = Lobes{}.pdf_cosine(cosine);
        return {Vec3(pdf), Vec3(pdf), pdf};
    }
    const Lobes::BrdfValue lit = values(model_->lights, at);
    Scattered out;
    out.of_light = (lit.diffuse + lit.specular) * cosine;
    out.of_environment = out.of_light;
    if (!model_->one_masking && !has_mirrors_alone()) {
        const Lobes::BrdfValue around = values(model_->environment, at);
        out.of_environment = (around.diffuse + around.specular) * cosine;
    }
    out.pdf = pdf(at);
    return out;
}

Scattered Bsdf::evaluate_specular(const Vec3& to_light) const {
    Cosines at;
    if (has_mirrors_alone() || !cosines(to_light, at)) return {};
    return {Vec3(0.0F), values(model_->environment, at).specular * at.n_dot_l, pdf(at)};
}

Bsdf::DiffuseShares Bsdf::diffuse_shares(const Vec3& to_light) const {
    constexpr float least = 1e-30F;
    if (is_far(to_light)) {
        const FarSide::Value value = of_far(to_light);
        const Vec3 share = value.diffuse / glm::max(value.diffuse + value.specular, Vec3(least));
        return {share, share};
    }
    Cosines at;
    if (!cosines(to_light, at)) return {};
    if (has_mirrors_alone()) return {Vec3(1.0F), Vec3(1.0F)};
    const auto share = [&](const Lobes& terms) {
        const Lobes::BrdfValue f = values(terms, at);
        return f.diffuse / glm::max(f.diffuse + f.specular, Vec3(least));
    };
    const Vec3 of_light = share(model_->lights);
    return {of_light, model_->one_masking ? of_light : share(model_->environment)};
}

float Bsdf::sheen_share() const {
    if (!has_sheen_) return 0.0F;
    const float through = is_coated_ ? 1.0F - coat_.albedo : 1.0F;
    return through * math::luminance(sheen_.albedo) /
           std::max(math::luminance(weight_below().diffuse), 1e-20F);
}

Lobes::BrdfValue Bsdf::environment_weight() const {
    Lobes::BrdfValue weight = weight_below();
    if (is_coated_) weight.specular += Vec3(coat_.albedo);
    return weight;
}

Bsdf::Sample Bsdf::mirrored(const Vec3& normal, const Vec3& share) const {
    Sample out;
    out.direction = normal * (2.0F * math::dot(normal, to_eye_)) - to_eye_;
    out.is_mirror = true;
    out.is_valid = math::dot(face_normal_, out.direction) > 0.0F;
    out.scattered = {share, share, 1.0F};
    return out;
}

Bsdf::Sample Bsdf::sample_far(Vec2 u, float lobe) const {
    const FarSide::Sample found = far_->sample(u, lobe);
    Sample out;
    if (found.to_light == Vec3(0.0F)) return out;
    out.direction = frame_.world(found.to_light);
    out.is_mirror = found.is_mirror;
    out.is_straight = found.is_straight;
    if (found.is_straight) out.direction = -to_eye_;
    if (!found.is_mirror) {
        out.scattered = evaluate(out.direction);
        out.is_valid = out.scattered.pdf > 0.0F;
        return out;
    }
    const Vec3 share = found.share / far_share_;
    out.scattered = {share, share, 1.0F};
    out.is_valid = math::dot(face_normal_, out.direction) * found.to_light.z > 0.0F;
    return out;
}

Vec3 Bsdf::sample_base(Vec2 u, float lobe) const {
    Lobes terms = model_->environment;
    if (!is_anisotropic_ || lobe >= sampler_.specular)
        return terms.brdf_sample(view_, sampler_, u, lobe);
    const Vec3 h = terms.sample_ggx_anisotropic(local_eye_, alpha_xy_, u);
    return h * (2.0F * math::dot(local_eye_, h)) - local_eye_;
}

Bsdf::Sample Bsdf::sample(Vec2 u, float lobe) const {
    if (lobe < far_share_) return sample_far(u, lobe / far_share_);
    const float near = 1.0F - far_share_;
    lobe = (lobe - far_share_) / near;
    Lobes terms = model_->environment;
    Vec3 local;
    const LobeFrame* frame = &frame_;
    const float others = 1.0F - coat_share_;
    if (is_white_) {
        local = terms.sample_cosine(u);
    } else if (lobe < coat_share_) {
        if (is_coat_mirror_)
            return mirrored(coat_frame_.z, Vec3(terms.coat_mirror(coat_) / (coat_share_ * near)));
        frame = &coat_frame_;
        const Vec3 h = terms.slot_sample_half(coat_to_eye_, coat_.alpha, u);
        local = h * (2.0F * math::dot(coat_to_eye_, h)) - coat_to_eye_;
    } else {
        const float of_base = (lobe - coat_share_) / others;
        if (is_mirror_ && of_base < sampler_.specular) {
            const Vec3 share = terms.brdf_mirror(view_) * left_by_layers();
            return mirrored(frame_.z, share / (sampler_.specular * others * near));
        }
        local = sample_base(u, of_base);
    }
    Sample out;
    if (local.z <= 0.0F) return out;
    out.direction = frame->world(local);
    out.scattered = evaluate(out.direction);
    out.is_valid = out.scattered.pdf > 0.0F;
    return out;
}

}  // namespace facet::trace
