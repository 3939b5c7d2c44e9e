// Directions of light drawn at a surface.
// SPDX-License-Identifier: MIT
#include "brdf/draw.h"

#include <cmath>

namespace facet::brdf {
namespace {

using Lobe = Terms<double>;

Lobe::BrdfView view_of(Lobe& terms, const QuerySurface& s, Queries& queries) {
    auto surface = terms.brdf_surface(Lobe::real3(s.base), s.metallic, s.roughness);
    surface.dielectric_f0 = Lobe::real3(s.f0);
    const ExactAlbedo& albedo = queries.albedo(s.n_dot_v, s.roughness);
    return terms.brdf_view(surface, s.n_dot_v, {albedo.a, albedo.b, albedo.average, 1.0});
}

}  // namespace

Draws::Draws(const tables::BrdfChoice& choice, const QuerySurface& surface, Queries& queries,
             std::uint32_t seed)
    : terms_{choice},
      surface_(surface),
      queries_(queries),
      v_(std::sqrt(1.0 - surface.n_dot_v * surface.n_dot_v), 0.0, surface.n_dot_v),
      view_(view_of(terms_, surface, queries)),
      sampler_(terms_.brdf_sampler(view_, v_)),
      engine_(seed) {}

Drawn Draws::next(Sampler sampler) {
    const double u0 = random(), u1 = random(), lobe = random();
    Drawn out;
    if (sampler == Sampler::uniform) out.l = terms_.sample_uniform({u0, u1});
    if (sampler == Sampler::cosine) out.l = terms_.sample_cosine({u0, u1});
    if (sampler == Sampler::brdf) out.l = terms_.brdf_sample(view_, sampler_, {u0, u1}, lobe);
    if (out.l.z <= 0.0) return out;
    const Lobe::real3 h = glm::normalize(v_ + out.l);
    const LightNode at{out.l.z, h.z, glm::dot(v_, h), 0.0};
    if (sampler == Sampler::uniform) out.pdf = terms_.pdf_uniform(out.l.z);
    if (sampler == Sampler::cosine) out.pdf = terms_.pdf_cosine(out.l.z);
    if (sampler == Sampler::brdf)
        out.pdf = terms_.brdf_pdf(view_, sampler_, at.n_dot_l, at.n_dot_h, at.v_dot_h);
    out.value = queries_.value(QueryTerm::full, surface_, at);
    return out;
}

}  // namespace facet::brdf
