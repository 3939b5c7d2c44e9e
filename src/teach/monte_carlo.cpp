// The rendering equation by drawing directions.
// SPDX-License-Identifier: MIT
#include "teach/monte_carlo.h"

#include "brdf/terms.h"
#include "teach/ask.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace facet::teach {
namespace {

using Lobe = brdf::Terms<double>;
constexpr std::string_view sampler_names[] = {"uniform", "cosine", "brdf"};
constexpr std::uint32_t repetitions = 96;

}  // namespace

bool is_sampler(std::string_view name) {
    return std::ranges::find(sampler_names, name) != std::end(sampler_names);
}

Sampling sampling_of(const Ask& ask) {
    Sampling out{.choice = ask.choice,
                 .surface = {std::max(ask.roughness, 1e-3), ask.metallic, ask.f0, ask.base,
                             std::max(ask.n_dot_v, 1e-3)},
                 .sampler = Sampler::cosine,
                 .samples = static_cast<std::uint32_t>(ask.samples)};
    for (std::size_t i = 0; i < std::size(sampler_names); ++i)
        if (sampler_names[i] == ask.sampler) out.sampler = static_cast<Sampler>(i);
    return out;
}

double estimate(brdf::Queries& queries, const Sampling& sampling, std::uint32_t seed) {
    const brdf::QuerySurface& s = sampling.surface;
    Lobe terms{sampling.choice};
    auto surface = terms.brdf_surface(Lobe::real3(s.base), s.metallic, s.roughness);
    surface.dielectric_f0 = s.f0;
    const brdf::ExactAlbedo& albedo = queries.albedo(s.n_dot_v, s.roughness);
    const auto view =
        terms.brdf_view(surface, s.n_dot_v, {albedo.a, albedo.b, albedo.average, 1.0});
    const Lobe::real3 v(std::sqrt(1.0 - s.n_dot_v * s.n_dot_v), 0.0, s.n_dot_v);
    const auto sampler = terms.brdf_sampler(view, v);
    std::mt19937 engine(seed);
    const auto next = [&] { return static_cast<double>(engine()) / 4294967296.0; };
    double sum = 0.0;
    for (std::uint32_t i = 0; i < sampling.samples; ++i) {
        const double u0 = next(), u1 = next(), lobe = next();
        Lobe::real3 l(0.0);
        if (sampling.sampler == Sampler::uniform) l = terms.sample_uniform({u0, u1});
        if (sampling.sampler == Sampler::cosine) l = terms.sample_cosine({u0, u1});
        if (sampling.sampler == Sampler::brdf) l = terms.brdf_sample(view, sampler, {u0, u1}, lobe);
        if (l.z <= 0.0) continue;  // counts as 0
        const Lobe::real3 h = glm::normalize(v + l);
        const brdf::LightNode at{l.z, h.z, glm::dot(v, h), 0.0};
        double pdf = terms.pdf_uniform(l.z);
        if (sampling.sampler == Sampler::cosine) pdf = terms.pdf_cosine(l.z);
        if (sampling.sampler == Sampler::brdf)
            pdf = terms.brdf_pdf(view, sampler, at.n_dot_l, at.n_dot_h, at.v_dot_h);
        if (pdf > 0.0) sum += queries.value(brdf::QueryTerm::full, s, at) * l.z / pdf;
    }
    return sum / static_cast<double>(sampling.samples);
}

double relative_error(brdf::Queries& queries, const Sampling& sampling, double truth) {
    double sum = 0.0;
    for (std::uint32_t i = 0; i < repetitions; ++i) {
        const double off = estimate(queries, sampling, i + 1) - truth;
        sum += off * off;
    }
    return std::sqrt(sum / repetitions) / std::max(truth, 1e-12);
}

}  // namespace facet::teach
