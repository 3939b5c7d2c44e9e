// How much a surface reflects in all.
// SPDX-License-Identifier: MIT
#include "brdf/albedo.h"

#include "brdf/gauss_legendre.h"
#include "brdf/terms.h"

#include <algorithm>
#include <cmath>

namespace facet::brdf {
namespace {

using tables::BrdfChoice;
using Lobe = Terms<double>;
using Color = Lobe::real3;

constexpr double pi = Lobe::PI;
constexpr double smallest_cosine = 1e-4;  // the edges stand in for what is a limit there
constexpr double smallest_alpha = 1e-4;

/// Points per half turn of azimuth, and from the normal to the horizon.
struct Rules {
    Quadrature azimuth;
    Quadrature inclination;
};
/// For the table, whose interpolation errs more: 5e-4 at worst, from roughness 0.03 and n.v 0.01
/// on. The points lie where GGX has its density; other distributions need more of them.
Rules table_rules(tables::Distribution distribution) {
    return {gauss_legendre(5), gauss_legendre(distribution == tables::Distribution::ggx ? 12 : 32)};
}
Rules exact_rules() { return {gauss_legendre(16), gauss_legendre(48)}; }

/// The lobe of environment light.
Lobe environment_lobe(const BrdfChoice& choice) {
    Lobe lobe{choice};
    lobe.choice.masking = choice.environment_masking;
    return lobe;
}

struct Albedos {
    double white = 0.0;       ///< F = 1
    double dielectric = 0.0;  ///< F of F0 = 0.04
};

/// One azimuth of h: integral over its inclination theta of D V F 4 (v.h)(n.l) sin(theta) (dl = 4
/// (v.h) dh; Walter et al. 2007, Eq. 14), up to where l meets the horizon. tan(theta) = alpha
/// tan(x) makes GGX's density flat in sin^2(x); x is held by q = tan(x/2), so that no point costs a
/// sine; q = top s^2 (3 - 2s) crowds points at the normal and at the horizon, where masking turns
/// fast.
Albedos over_inclination(Lobe& lobe, const Quadrature& rule, const Color& v_cos_phi,
                         double roughness, double alpha) {
    const double side = v_cos_phi.x;
    const double n_dot_v = v_cos_phi.z;
    // n.l = sqrt(side^2 + n_dot_v^2) cos(2 theta - atan2(side, n_dot_v))
    const double tan_horizon = std::tan(0.5 * std::atan2(side, n_dot_v) + 0.25 * pi) / alpha;
    const double top = tan_horizon / (1.0 + std::sqrt(1.0 + tan_horizon * tan_horizon));
    Albedos sum;
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
        const double s = rule.points[i];
        const double q = top * s * s * (3.0 - 2.0 * s);
        const double q2 = q * q;
        const double rise = alpha * 2.0 * q;  // tan(theta) = rise / run
        const double run = 1.0 - q2;
        const double scale = 1.0 / std::sqrt(rise * rise + run * run);
        const double n_dot_h = run * scale;
        const double sin_theta = rise * scale;
        const double v_dot_h = side * sin_theta + n_dot_v * n_dot_h;
        const double n_dot_l = 2.0 * v_dot_h * n_dot_h - n_dot_v;
        if (n_dot_l <= 0.0 || v_dot_h <= 0.0) continue;  // rounding at the horizon
        const double dq = top * 6.0 * s * (1.0 - s) * rule.weights[i];
        const double dtheta = alpha * 2.0 * (1.0 + q2) * scale * scale * dq;
        const double weight = lobe.slot_distribution(n_dot_h, alpha) *
                              lobe.slot_masking(n_dot_v, n_dot_l, roughness, alpha) * 4.0 *
                              v_dot_h * n_dot_l * sin_theta * dtheta;
        const Color f =
            lobe.slot_fresnel(Color(Lobe::DIELECTRIC_F0), Color(1.0), std::min(1.0, v_dot_h));
        sum.white += weight;
        sum.dielectric += weight * f.x;
    }
    return sum;
}

SplitSum integrate(Lobe& lobe, const Rules& rules, double cosine, double roughness) {
    const double n_dot_v = std::clamp(cosine, smallest_cosine, 1.0);
    const double alpha = std::max(smallest_alpha, lobe.slot_width(roughness));
    const double sin_v = std::sqrt((1.0 - n_dot_v) * (1.0 + n_dot_v));
    Albedos sum;
    for (std::size_t i = 0; i < rules.azimuth.points.size(); ++i)
        // The two quarter turns apart: seen edge on, facets that turn away end at a right angle.
        for (const double sign : {1.0, -1.0}) {
            const double side = sign * sin_v * std::cos(0.5 * pi * rules.azimuth.points[i]);
            const Albedos part =
                over_inclination(lobe, rules.inclination, {side, 0.0, n_dot_v}, roughness, alpha);
            // Both halves of the turn are alike: 2 (pi / 2).
            sum.white += part.white * pi * rules.azimuth.weights[i];
            sum.dielectric += part.dielectric * pi * rules.azimuth.weights[i];
        }
    constexpr double f0 = Lobe::DIELECTRIC_F0;
    const double b = (sum.dielectric - f0 * sum.white) / (1.0 - f0);
    return {.a = sum.white - b, .b = b};
}

/// 2 integral(E mu dmu) with mu = x^2, which spreads the steep end.
double integrate_average(Lobe& lobe, const Rules& rules, const Quadrature& cosines,
                         double roughness) {
    double sum = 0.0;
    for (std::size_t i = 0; i < cosines.points.size(); ++i) {
        const double x = cosines.points[i];
        const SplitSum e = integrate(lobe, rules, x * x, roughness);
        sum += 4.0 * x * x * x * cosines.weights[i] * (e.a + e.b);
    }
    return sum;
}

/// Albedo of the white diffuse lobe where it has no closed form; else 1, which multiplies nothing.
double diffuse_albedo(Lobe& lobe, const Quadrature& rule, double n_dot_v, double roughness) {
    if (lobe.choice.diffuse != tables::Diffuse::burley) return 1.0;
    const double sin_v = std::sqrt((1.0 - n_dot_v) * (1.0 + n_dot_v));
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.points.size(); ++i)
        for (std::size_t j = 0; j < rule.points.size(); ++j) {
            const double n_dot_l = rule.points[i];
            const double sin_l = std::sqrt((1.0 - n_dot_l) * (1.0 + n_dot_l));
            const double v_dot_l =
                n_dot_v * n_dot_l + sin_v * sin_l * std::cos(pi * rule.points[j]);
            const double v_dot_h = std::sqrt(std::max(0.0, 0.5 + 0.5 * v_dot_l));
            sum += lobe.slot_diffuse(Color(1.0), roughness, n_dot_v, n_dot_l, v_dot_h).x * n_dot_l *
                   rule.weights[i] * rule.weights[j];
        }
    return 2.0 * pi * sum;
}

}  // namespace

SplitSum split_sum(const BrdfChoice& choice, double n_dot_v, double roughness) {
    Lobe lobe = environment_lobe(choice);
    return integrate(lobe, exact_rules(), n_dot_v, roughness);
}

double average_albedo(const BrdfChoice& choice, double roughness) {
    Lobe lobe = environment_lobe(choice);
    return integrate_average(lobe, exact_rules(), gauss_legendre(24), roughness);
}

AlbedoTable albedo_table(const BrdfChoice& choice) {
    Lobe lobe = environment_lobe(choice);
    const Rules rules = table_rules(choice.distribution);
    const Quadrature cosines = gauss_legendre(8);  // error of the mean 3e-4
    constexpr auto size = static_cast<std::uint32_t>(Lobe::ALBEDO_TABLE_SIZE);
    constexpr double step = 1.0 / (Lobe::ALBEDO_TABLE_SIZE - 1.0);
    AlbedoTable table{.size = size, .texels = {}};
    table.texels.reserve(std::size_t{size} * size * 4);
    for (std::uint32_t row = 0; row < size; ++row) {
        const double y = row * step;  // the inverse of albedo_coordinates.glsl
        const double roughness = y * y;
        const double average = integrate_average(lobe, rules, cosines, roughness);
        for (std::uint32_t column = 0; column < size; ++column) {
            const double x = column * step;
            const double n_dot_v = std::max(x * x * x * x, smallest_cosine);
            const SplitSum sum = integrate(lobe, rules, n_dot_v, roughness);
            for (const double value : {sum.a, sum.b, average,
                                       diffuse_albedo(lobe, rules.inclination, n_dot_v, roughness)})
                table.texels.push_back(static_cast<float>(value));
        }
    }
    return table;
}

}  // namespace facet::brdf
