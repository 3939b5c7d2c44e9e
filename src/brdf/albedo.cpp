// How much a surface reflects in all.
// SPDX-License-Identifier: MIT
#include "brdf/albedo.h"

#include "brdf/half_vectors.h"
#include "brdf/terms.h"

#include <algorithm>
#include <cmath>

namespace facet::brdf {
namespace {

using tables::BrdfChoice;
using Lobe = Terms<double>;
using Color = Lobe::real3;

constexpr double smallest_alpha = 1e-4;

/// For the table, whose interpolation errs more: 5e-4 at worst, from roughness 0.03 and n.v 0.01
/// on. The points lie where GGX has its density; other distributions need more of them.
HalfVectorRule table_rule(tables::Distribution distribution) {
    return {gauss_legendre(5), gauss_legendre(distribution == tables::Distribution::ggx ? 12 : 32)};
}
const HalfVectorRule& exact_rule() {
    static const HalfVectorRule rule{gauss_legendre(16), gauss_legendre(48)};
    return rule;
}

/// The lobe of environment light.
Lobe environment_lobe(const BrdfChoice& choice) {
    Lobe lobe{choice};
    lobe.choice.masking = choice.environment_masking;
    return lobe;
}

SplitSum integrate(Lobe& lobe, const HalfVectorRule& rule, double cosine, double roughness) {
    const double n_dot_v = std::clamp(cosine, smallest_cosine, 1.0);
    const double alpha = std::max(smallest_alpha, lobe.slot_width(roughness));
    double white = 0.0;       // F = 1
    double dielectric = 0.0;  // F of F0 = 0.04
    over_half_vectors(rule, n_dot_v, alpha, [&](const LightNode& node) {
        const double d_v = lobe.slot_distribution(node.n_dot_h, alpha) *
                           lobe.slot_masking(n_dot_v, node.n_dot_l, roughness, alpha) * node.weight;
        const Color f = lobe.slot_fresnel(Color(Lobe::DIELECTRIC_F0), Color(1.0), node.v_dot_h);
        white += d_v;
        dielectric += d_v * f.x;
    });
    constexpr double f0 = Lobe::DIELECTRIC_F0;
    const double b = (dielectric - f0 * white) / (1.0 - f0);
    return {.a = white - b, .b = b};
}

/// 2 integral(E mu dmu) with mu = x^2, which spreads the steep end.
double integrate_average(Lobe& lobe, const HalfVectorRule& rule, const Quadrature& cosines,
                         double roughness) {
    double sum = 0.0;
    for (std::size_t i = 0; i < cosines.points.size(); ++i) {
        const double x = cosines.points[i];
        const SplitSum e = integrate(lobe, rule, x * x, roughness);
        sum += 4.0 * x * x * x * cosines.weights[i] * (e.a + e.b);
    }
    return sum;
}

/// Albedo of the white diffuse lobe where it has no closed form; else 1, which multiplies nothing.
double diffuse_albedo(Lobe& lobe, const HalfVectorRule& rule, double n_dot_v, double roughness) {
    if (lobe.choice.diffuse != tables::Diffuse::burley) return 1.0;
    double sum = 0.0;
    over_hemisphere({rule.inclination, rule.inclination}, n_dot_v, [&](const LightNode& node) {
        sum += node.weight *
               lobe.slot_diffuse(Color(1.0), roughness, n_dot_v, node.n_dot_l, node.v_dot_h).x;
    });
    return sum;
}

}  // namespace

SplitSum split_sum(const BrdfChoice& choice, double n_dot_v, double roughness) {
    Lobe lobe = environment_lobe(choice);
    return integrate(lobe, exact_rule(), n_dot_v, roughness);
}

double average_albedo(const BrdfChoice& choice, double roughness) {
    Lobe lobe = environment_lobe(choice);
    return integrate_average(lobe, exact_rule(), gauss_legendre(24), roughness);
}

AlbedoTable albedo_table(const BrdfChoice& choice) {
    Lobe lobe = environment_lobe(choice);
    const HalfVectorRule rule = table_rule(choice.distribution);
    const Quadrature cosines = gauss_legendre(8);  // error of the mean 3e-4
    constexpr auto size = static_cast<std::uint32_t>(Lobe::ALBEDO_TABLE_SIZE);
    constexpr double step = 1.0 / (Lobe::ALBEDO_TABLE_SIZE - 1.0);
    AlbedoTable table{.size = size, .texels = {}};
    table.texels.reserve(std::size_t{size} * size * 4);
    for (std::uint32_t row = 0; row < size; ++row) {
        const double y = row * step;  // the inverse of albedo_coordinates.glsl
        const double roughness = y * y;
        const double average = integrate_average(lobe, rule, cosines, roughness);
        for (std::uint32_t column = 0; column < size; ++column) {
            const double x = column * step;
            const double n_dot_v = std::max(x * x * x * x, smallest_cosine);
            const SplitSum sum = integrate(lobe, rule, n_dot_v, roughness);
            for (const double value :
                 {sum.a, sum.b, average, diffuse_albedo(lobe, rule, n_dot_v, roughness)})
                table.texels.push_back(static_cast<float>(value));
        }
    }
    return table;
}

}  // namespace facet::brdf
