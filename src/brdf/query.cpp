// One question about the BRDF, and its answer in double precision.
// SPDX-License-Identifier: MIT
#include "brdf/query.h"

#include "brdf/albedo.h"
#include "brdf/terms.h"

namespace facet::brdf {
namespace {

using Lobe = Terms<double>;
using Color = Lobe::real3;

constexpr double pi = Lobe::PI;

const HalfVectorRule& fine_rule() {
    static const HalfVectorRule rule{gauss_legendre(24), gauss_legendre(64)};
    return rule;
}

/// F0 of the surface as one number: the dielectric's, and the base colour of metal.
double mixed_f0(const QuerySurface& s) { return s.f0 * (1.0 - s.metallic) + s.base * s.metallic; }

/// Whether the answer may hang on the albedo at the light's direction.
bool is_lobe(QueryTerm term) { return term == QueryTerm::specular || term >= QueryTerm::full; }

}  // namespace

LightNode cosines_of(double n_dot_v, double n_dot_l, double phi_deg) {
    const double sines =
        std::sqrt(std::max(0.0, (1.0 - n_dot_v * n_dot_v) * (1.0 - n_dot_l * n_dot_l)));
    return light_node(n_dot_v, n_dot_l, n_dot_v * n_dot_l + sines * std::cos(phi_deg * pi / 180.0));
}

Queries::Queries(const tables::BrdfChoice& choice) : choice_(choice) {
    choice_.environment_masking = choice_.masking;
}

const ExactAlbedo& Queries::albedo(double n_dot_v, double roughness) {
    const auto [found, is_new] = albedos_.try_emplace({n_dot_v, roughness});
    if (!is_new) return found->second;
    const SplitSum sum = split_sum(choice_, n_dot_v, roughness);
    const auto [average, unknown] = averages_.try_emplace(roughness, 1.0);
    if (unknown && adds_lobe()) average->second = average_albedo(choice_, roughness);
    found->second = {sum.a, sum.b, average->second};
    return found->second;
}

double Queries::light_albedo(double n_dot_l, double roughness) {
    constexpr std::size_t steps = 96;
    auto& values = light_albedos_[roughness];
    if (values.empty())
        for (std::size_t i = 0; i <= steps; ++i) {
            const double x = static_cast<double>(i) / steps;
            const SplitSum sum =
                split_sum(choice_, std::max(x * x * x * x, smallest_cosine), roughness);
            values.push_back(sum.a + sum.b);
        }
    const double at = std::sqrt(std::sqrt(n_dot_l)) * steps;
    const auto below = std::min(static_cast<std::size_t>(at), steps - 1);
    const double share = at - static_cast<double>(below);
    return values[below] * (1.0 - share) + values[below + 1] * share;
}

double Queries::mixed_specular(const QuerySurface& surface, const LightNode& at, double e_l) {
    Lobe terms{choice_};
    const double alpha = terms.slot_width(surface.roughness);
    const Color f0(mixed_f0(surface));
    const double single =
        terms.slot_distribution(at.n_dot_h, alpha) *
        terms.slot_masking(surface.n_dot_v, at.n_dot_l, surface.roughness, alpha) *
        terms.slot_fresnel(f0, Color(1.0), at.v_dot_h).x;
    if (!terms.slot_conserves()) return single;
    const ExactAlbedo& e = albedo(surface.n_dot_v, surface.roughness);
    return single * terms.slot_multiscatter(f0, e.a + e.b).x +
           terms.slot_added(f0, e.a, e.b, e.average).x * terms.slot_added_shape(e_l, e.average);
}

double Queries::lobe(QueryTerm term, const QuerySurface& surface, const LightNode& at, double e_l) {
    if (term == QueryTerm::specular) return mixed_specular(surface, at, e_l);
    Lobe terms{choice_};
    auto s = terms.brdf_surface(Color(surface.base), surface.metallic, surface.roughness);
    s.dielectric_f0 = Color(surface.f0);
    const ExactAlbedo exact =
        terms.slot_conserves() ? albedo(surface.n_dot_v, surface.roughness) : ExactAlbedo{};
    // The albedo of the diffuse lobe is for the environment alone.
    const auto view = terms.brdf_view(s, surface.n_dot_v, {exact.a, exact.b, exact.average, 1.0});
    const auto value = terms.brdf_light(view, at.n_dot_l, at.n_dot_h, at.v_dot_h, e_l);
    if (term == QueryTerm::model_diffuse) return value.diffuse.x;
    return (term == QueryTerm::full ? value.diffuse + value.specular : value.specular).x;
}

double Queries::value(QueryTerm term, const QuerySurface& surface, const LightNode& at) {
    Lobe terms{choice_};
    const double alpha = terms.slot_width(surface.roughness);
    switch (term) {
        case QueryTerm::d:
            return terms.slot_distribution(at.n_dot_h, alpha);
        case QueryTerm::v:
            return terms.slot_masking(surface.n_dot_v, at.n_dot_l, surface.roughness, alpha);
        case QueryTerm::g:
            return 4.0 * surface.n_dot_v * at.n_dot_l *
                   terms.slot_masking(surface.n_dot_v, at.n_dot_l, surface.roughness, alpha);
        case QueryTerm::f:
            return terms.slot_fresnel(Color(mixed_f0(surface)), Color(1.0), at.v_dot_h).x;
        case QueryTerm::diffuse:
            return terms
                .slot_diffuse(Color(1.0), surface.roughness, surface.n_dot_v, at.n_dot_l,
                              at.v_dot_h)
                .x;
        case QueryTerm::specular:
        case QueryTerm::full:
        case QueryTerm::model_specular:
        case QueryTerm::model_diffuse:
            break;
    }
    return lobe(term, surface, at, adds_lobe() ? light_albedo(at.n_dot_l, surface.roughness) : 1.0);
}

double Queries::value(QueryTerm term, const QuerySurface& surface, double n_dot_l, double phi_deg) {
    const LightNode at = cosines_of(surface.n_dot_v, n_dot_l, phi_deg);
    if (!is_lobe(term) || !adds_lobe()) return value(term, surface, at);
    const ExactAlbedo& at_light = albedo(n_dot_l, surface.roughness);
    return lobe(term, surface, at, at_light.a + at_light.b);
}

std::vector<Question> reflectance_questions(const tables::BrdfChoice& choice,
                                            const QuerySurface& surface) {
    const HalfVectorRule& rule = fine_rule();
    Lobe terms{choice};
    const double alpha = std::max(1e-4, terms.slot_width(surface.roughness));
    QuerySurface held = surface;
    held.n_dot_v = std::max(surface.n_dot_v, smallest_cosine);
    std::vector<Question> out;
    over_half_vectors(rule, held.n_dot_v, alpha, [&](const LightNode& node) {
        out.push_back({QueryTerm::model_specular, held, node});
    });
    over_hemisphere({rule.azimuth, rule.azimuth}, held.n_dot_v, [&](const LightNode& node) {
        out.push_back({QueryTerm::model_diffuse, held, node});
    });
    return out;
}

Reflectance Queries::reflectance(const QuerySurface& surface) {
    const std::vector<Question> questions = reflectance_questions(choice_, surface);
    std::vector<double> answers;
    answers.reserve(questions.size());
    for (const Question& q : questions) answers.push_back(value(q.term, q.surface, q.at));
    return brdf::reflectance(questions, answers);
}

Reflectance reflectance(std::span<const Question> questions, std::span<const double> answers) {
    Reflectance out;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const Question& q = questions[i];
        (q.term == QueryTerm::model_specular ? out.specular : out.diffuse) +=
            q.at.weight * answers[i];
    }
    return out;
}

}  // namespace facet::brdf
