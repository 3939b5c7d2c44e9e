// Lobes that materials lay over the base: anisotropic GGX, sheen, clearcoat.
// SPDX-License-Identifier: MIT
#include "brdf/half_vectors.h"
#include "brdf/terms.h"
#include "support/directions.h"
#include "support/reference_table.h"

#include <gtest/gtest.h>

#include <random>

namespace facet::brdf {
namespace {

using Lobe = Terms<double>;
using Dir = Lobe::real3;
using test::direction_of;
using test::PairOfDirections;
using test::pi;

/// Integral over the hemisphere: midpoints in azimuth, and in the square root of 1 - cosine, which
/// crowds the pole.
template <class F>
double over_hemisphere_of(F f, int side = 600) {
    double sum = 0;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const double t = (i + 0.5) / side;
            sum += f(direction_of<Dir>(1 - t * t, (j + 0.5) / side * 2 * pi)) * 2 * t;
        }
    return sum * 2 * pi / (side * side);
}

const std::pair<double, double> both_widths[] = {{0.3, 0.3}, {0.5, 0.15}, {0.2, 1.0}};

// The projected microfacet area is the surface's (Walter et al. 2007, Section 3.1).
TEST(AnisotropicGgx, ProjectedAreaOfTheMicrofacetsIsOne) {
    Lobe lobe;
    for (const auto& [x, y] : both_widths)
        EXPECT_NEAR(over_hemisphere_of([&](const Dir& h) {
                        return lobe.d_ggx_anisotropic(h, {x, y}) * h.z;
                    }),
                    1.0, 2e-4)
            << x << " " << y;
}

// What a viewer sees of the facets is what it sees of the surface (Heitz 2014, Eq. 14).
TEST(AnisotropicGgx, VisibleFacetsFillTheProjectedSurface) {
    Lobe lobe;
    for (const auto& [x, y] : both_widths)
        for (const double phi : {0.0, 0.7, 1.5}) {
            const Dir v = direction_of<Dir>(0.5, phi);
            // 2 V n.l at l -> the limit of no shadowing is not at hand: G1 from the sampler's
            // density instead.
            const double seen = over_hemisphere_of([&](const Dir& h) {
                const double v_dot_h = std::max(0.0, glm::dot(v, h));
                return lobe.pdf_ggx_anisotropic(v, h, {x, y}) * 4 * v_dot_h;
            });
            EXPECT_NEAR(seen, 1.0, 1e-3) << x << " " << y << " phi " << phi;
        }
}

TEST(AnisotropicGgx, OfEqualWidthsIsTheIsotropicOne) {
    Lobe lobe;
    const Dir v = direction_of<Dir>(0.4, 0.3), l = direction_of<Dir>(0.8, 2.0),
              h = glm::normalize(v + l);
    const double a = 0.36;
    EXPECT_NEAR(lobe.d_ggx_anisotropic(h, {a, a}), lobe.d_ggx(h.z, a), 1e-12);
    EXPECT_NEAR(lobe.v_smith_ggx_anisotropic(v, l, {a, a}),
                lobe.v_smith_ggx_correlated(v.z, l.z, a), 1e-12);
    EXPECT_NEAR(lobe.pdf_ggx_anisotropic(v, h, {a, a}), lobe.pdf_ggx(v.z, h.z, a), 1e-12);
}

TEST(AnisotropicGgx, IsReciprocal) {
    Lobe lobe;
    const Dir v = direction_of<Dir>(0.15, 0.3), l = direction_of<Dir>(0.8, 2.0);
    EXPECT_NEAR(lobe.v_smith_ggx_anisotropic(v, l, {0.2, 0.7}),
                lobe.v_smith_ggx_anisotropic(l, v, {0.2, 0.7}), 1e-12);
}

// The weight of a visible normal is F G2 / G1: at most 1, and its mean is the albedo, which no
// table has for two widths; so it is held against a quadrature of the lobe.
TEST(AnisotropicGgx, SampledAlbedoEqualsQuadratureWithinThreeStandardErrors) {
    Lobe lobe;
    std::mt19937 engine(9);
    const auto next = [&] { return static_cast<double>(engine()) / 4294967296.0; };
    for (const auto& [x, y] : both_widths) {
        const Dir v = direction_of<Dir>(0.6, 0.5);
        const Lobe::real2 alpha{x, y};
        double sum = 0, squares = 0;
        constexpr int draws = 40'000;
        for (int i = 0; i < draws; ++i) {
            const double u0 = next();
            const Dir h = lobe.sample_ggx_anisotropic(v, alpha, {u0, next()});
            const Dir l = h * (2 * glm::dot(v, h)) - v;
            if (l.z <= 0) continue;
            const double weight = lobe.d_ggx_anisotropic(h, alpha) *
                                  lobe.v_smith_ggx_anisotropic(v, l, alpha) * l.z /
                                  lobe.pdf_ggx_anisotropic(v, h, alpha);
            ASSERT_LE(weight, 1.0 + 1e-9);
            sum += weight;
            squares += weight * weight;
        }
        const double mean = sum / draws;
        const double exact = over_hemisphere_of([&](const Dir& l) {
            const Dir h = glm::normalize(v + l);
            return lobe.d_ggx_anisotropic(h, alpha) * lobe.v_smith_ggx_anisotropic(v, l, alpha) *
                   l.z;
        });
        EXPECT_NEAR(mean, exact, 3 * std::sqrt((squares / draws - mean * mean) / draws) + 1e-3)
            << x << " " << y;
    }
}

TEST(Sheen, DistributionEqualsTheTableAndItsProjectedAreaIsOne) {
    Lobe lobe;
    for (const auto& row : test::reference_rows("d_charlie"))
        EXPECT_NEAR(lobe.d_charlie(row["n_dot_h"], row["alpha"]), row["D"], 1e-6 * row["D"] + 1e-12)
            << row.shown;
    for (const double alpha : {0.05, 0.3, 1.0})
        EXPECT_NEAR(
            over_hemisphere_of([&](const Dir& h) { return lobe.d_charlie(h.z, alpha) * h.z; }), 1.0,
            1e-3)
            << alpha;
}

TEST(Sheen, VisibilityEqualsTheTable) {
    Lobe lobe;
    for (const auto& row : test::reference_rows("v_sheen")) {
        const double alpha = row["roughness"] * row["roughness"];
        EXPECT_NEAR(lobe.v_charlie(row["n_dot_v"], row["n_dot_l"], alpha), row["V_charlie"],
                    1e-6 * row["V_charlie"])
            << row.shown;
        EXPECT_NEAR(lobe.v_neubelt(row["n_dot_v"], row["n_dot_l"]), row["V_neubelt"],
                    1e-6 * row["V_neubelt"])
            << row.shown;
    }
}

TEST(Sheen, SampledAlbedoEqualsTheTableWithinThreeStandardErrors) {
    Lobe lobe;
    std::mt19937 engine(2);
    const auto next = [&] { return static_cast<double>(engine()) / 4294967296.0; };
    for (const auto& row : test::reference_rows("albedo_sheen_diffuse")) {
        const double alpha = row["roughness"] * row["roughness"];
        const Dir v = direction_of<Dir>(row["n_dot_v"], 0.0);
        double sum = 0, squares = 0;
        constexpr int draws = 20'000;
        for (int i = 0; i < draws; ++i) {
            const double u0 = next();
            const Dir l = lobe.sample_uniform({u0, next()});
            const Dir h = glm::normalize(v + l);
            const double weight = lobe.d_charlie(h.z, alpha) *
                                  lobe.v_charlie(v.z, std::max(l.z, 1e-9), alpha) * l.z /
                                  lobe.pdf_uniform(l.z);
            sum += weight;
            squares += weight * weight;
        }
        const double mean = sum / draws;
        EXPECT_NEAR(mean, row["sheen_charlie"],
                    3 * std::sqrt((squares / draws - mean * mean) / draws) + 1e-4)
            << row.shown;
    }
}

// A GGX lobe of F0 0.04 by the albedo table's split sum would share its formulas; the half-vector
// rule does not.
TEST(Clearcoat, IsReciprocalAndReflectsNoMoreThanItsFresnelTerm) {
    Lobe lobe;
    const PairOfDirections forth(0.3, 0.8, 140), back(0.8, 0.3, 140);
    const double f = lobe.clearcoat(0.3, 0.8, forth.n_dot_h, forth.v_dot_h, 0.4);
    EXPECT_NEAR(lobe.clearcoat(0.8, 0.3, back.n_dot_h, back.v_dot_h, 0.4), f, 1e-10 * f);
    for (const double roughness : {0.05, 0.3, 1.0})
        for (const double n_dot_v : {0.05, 0.5, 1.0}) {
            double albedo = 0;
            over_half_vectors({gauss_legendre(16), gauss_legendre(48)}, n_dot_v,
                              roughness * roughness, [&](const LightNode& node) {
                                  albedo += node.weight * lobe.clearcoat(n_dot_v, node.n_dot_l,
                                                                         node.n_dot_h, node.v_dot_h,
                                                                         roughness);
                              });
            EXPECT_LE(albedo, lobe.f_schlick(Dir(0.04), 0.0).x);
            if (roughness < 0.1 && n_dot_v == 1.0) {
                EXPECT_NEAR(albedo, 0.04, 1e-4);
            }
        }
}

}  // namespace
}  // namespace facet::brdf
