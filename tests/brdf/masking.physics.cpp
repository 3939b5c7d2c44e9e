// Masking and shadowing: tables, symmetry, and Smith's condition on the visible area.
// SPDX-License-Identifier: MIT
#include "brdf/terms.h"
#include "support/directions.h"
#include "support/reference_table.h"

#include <gtest/gtest.h>

namespace facet::brdf {
namespace {

using tables::Distribution;
using tables::Masking;
using test::pi;
using test::reference_rows;

constexpr double masking_digits = 2e-9;  // relative; the tables have ten digits

constexpr Masking every_masking[] = {Masking::smith_correlated, Masking::smith,
                                     Masking::schlick_direct, Masking::schlick_ibl, Masking::none};

/// G from V: G = 4 n.v n.l V.
double g_of(const tables::BrdfChoice& choice, double n_dot_v, double n_dot_l, double roughness,
            double alpha) {
    Terms<double> terms{choice};
    return 4 * n_dot_v * n_dot_l * terms.slot_masking(n_dot_v, n_dot_l, roughness, alpha);
}

TEST(MaskingTables, SmithForGgxEqualsTheTable) {
    Terms<double> terms;
    for (const auto& row : reference_rows("g_smith_ggx")) {
        const double v = row["n_dot_v"];
        const double l = row["n_dot_l"];
        const double alpha = row["alpha"];
        EXPECT_NEAR(terms.v_smith_ggx_correlated(v, l, alpha), row["V_correlated"],
                    masking_digits * row["V_correlated"])
            << row.shown;
        EXPECT_NEAR(4 * v * l * terms.v_smith_ggx(v, l, alpha), row["G2_separable"],
                    masking_digits * row["G2_separable"])
            << row.shown;
    }
}

TEST(MaskingTables, SmithForBeckmannEqualsTheTable) {
    for (const auto& row : reference_rows("g_smith_beckmann")) {
        const double v = row["n_dot_v"];
        const double alpha = row["alpha"];
        const double g2 = g_of({.distribution = Distribution::beckmann}, v, row["n_dot_l"],
                               std::sqrt(alpha), alpha);
        EXPECT_NEAR(g2, row["G2_correlated"], masking_digits) << row.shown;
        // Nothing hides a light straight above, which leaves G1 of the view.
        const double g1 = g_of({.distribution = Distribution::beckmann, .masking = Masking::smith},
                               v, 1.0, std::sqrt(alpha), alpha);
        EXPECT_NEAR(g1, row["G1"], masking_digits) << row.shown;
    }
}

TEST(MaskingTables, TheLecturesSchlickEqualsTheTable) {
    for (const auto& row : reference_rows("g_seed")) {
        const double r = row["roughness"];
        EXPECT_NEAR(
            g_of({.masking = Masking::schlick_direct}, row["n_dot_v"], row["n_dot_l"], r, r * r),
            row["G_direct"], masking_digits)
            << row.shown;
        EXPECT_NEAR(
            g_of({.masking = Masking::schlick_ibl}, row["n_dot_v"], row["n_dot_l"], r, r * r),
            row["G_ibl"], masking_digits)
            << row.shown;
    }
}

// Heitz 2014, Eq. 14: the visible microfacets, projected towards v, fill the macrosurface's
// projection: integral of G1(v) <v.h> D(h) dh = n.v. With a light straight above G2 is G1.
TEST(MaskingLaws, VisibleMicrofacetsFillTheProjectedSurface) {
    for (const auto distribution : {Distribution::ggx, Distribution::beckmann})
        for (const double alpha : {0.1, 0.36, 1.0})
            for (const double n_dot_v : {0.1, 0.5, 0.9}) {
                Terms<double> terms{{.distribution = distribution}};
                const double sin_v = std::sqrt(1 - n_dot_v * n_dot_v);
                const double facing = test::over_polar_cosine(
                    [&](double c) {
                        // Mean of max(0, a + b cos phi) over the azimuth of h, closed form.
                        const double a = n_dot_v * c;
                        const double b = sin_v * std::sqrt(std::max(0.0, 1 - c * c));
                        const double mean =
                            a >= b ? a : (a * std::acos(-a / b) + std::sqrt(b * b - a * a)) / pi;
                        return terms.slot_distribution(c, alpha) * mean;
                    },
                    20000);
                const double g1 = g_of({.distribution = distribution, .masking = Masking::smith},
                                       n_dot_v, 1.0, 0.0, alpha);
                EXPECT_NEAR(g1 * facing / n_dot_v, 1.0, 1e-5)
                    << static_cast<int>(distribution) << " alpha " << alpha << " n.v " << n_dot_v;
            }
}

TEST(MaskingLaws, IsTheSameWithViewAndLightExchanged) {
    for (const auto distribution : {Distribution::ggx, Distribution::beckmann})
        for (const Masking masking : every_masking)
            for (const double r : {0.05, 0.3, 1.0}) {
                const tables::BrdfChoice choice{.distribution = distribution, .masking = masking};
                EXPECT_DOUBLE_EQ(g_of(choice, 0.2, 0.7, r, r * r),
                                 g_of(choice, 0.7, 0.2, r, r * r));
            }
}

TEST(MaskingLaws, HidesAShareBetweenNothingAndAll) {
    for (const auto distribution : {Distribution::ggx, Distribution::beckmann})
        for (const Masking masking : every_masking)
            for (double r = 0.05; r <= 1.0; r += 0.19)
                for (double v = 0.01; v <= 1.0; v += 0.11)
                    for (double l = 0.01; l <= 1.0; l += 0.11) {
                        const double g = g_of({.distribution = distribution, .masking = masking}, v,
                                              l, r, r * r);
                        ASSERT_TRUE(g >= 0 && g <= 1 + 1e-12)
                            << static_cast<int>(masking) << " r " << r << ": " << g;
                    }
}

TEST(MaskingLaws, IsFiniteAtEveryEdgeInFloat) {
    for (const auto distribution :
         {Distribution::ggx, Distribution::beckmann, Distribution::blinn_phong})
        for (const Masking masking : every_masking) {
            Terms<float> terms{{.distribution = distribution, .masking = masking}};
            for (const float r : {0.0F, 0.05F, 1.0F})
                for (const float v : {0.0F, 1e-6F, 1.0F})
                    for (const float l : {0.0F, 1e-6F, 1.0F}) {
                        const float x = terms.slot_masking(v, l, r, r * r);
                        EXPECT_TRUE(std::isfinite(x) && x >= 0.0F)
                            << static_cast<int>(masking) << " r " << r << " " << v << " " << l
                            << ": " << x;
                    }
        }
}

}  // namespace
}  // namespace facet::brdf
