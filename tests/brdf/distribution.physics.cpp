// The normal distributions: tables, and the area that every one of them must have.
// SPDX-License-Identifier: MIT
#include "brdf/terms.h"
#include "support/directions.h"
#include "support/reference_table.h"

#include <gtest/gtest.h>

namespace facet::brdf {
namespace {

using test::over_polar_cosine;
using test::reference_rows;

// Tables have ten digits; the terms round a handful of times.
constexpr double distribution_digits = 1e-9;

template <class F>
void expect_table(const std::string& name, F term) {
    for (const auto& row : reference_rows(name)) {
        const double expected = row["D"];
        EXPECT_NEAR(term(row["n_dot_h"], row["alpha"]), expected,
                    distribution_digits * expected + 1e-300)
            << row.shown;
    }
}

TEST(DistributionTables, GgxEqualsTheTable) {
    Terms<double> terms;
    expect_table("d_ggx",
                 [&](double n_dot_h, double alpha) { return terms.d_ggx(n_dot_h, alpha); });
}

TEST(DistributionTables, BeckmannEqualsTheTable) {
    Terms<double> terms;
    expect_table("d_beckmann",
                 [&](double n_dot_h, double alpha) { return terms.d_beckmann(n_dot_h, alpha); });
}

// Condition of 1 - c near c = 1 is the argument's, so float inputs are compared as the floats they
// are.
TEST(DistributionTables, FloatEqualsDoubleToFivePartsInAMillion) {
    Terms<float> narrow;
    Terms<double> wide;
    for (const float alpha : {0.0025F, 0.01F, 0.1F, 0.5F, 1.0F})
        for (const float n_dot_h : {0.0F, 0.1F, 0.5F, 0.9F, 0.99F, 0.9999F, 1.0F}) {
            const double ggx = wide.d_ggx(double{n_dot_h}, double{alpha});
            EXPECT_NEAR(double{narrow.d_ggx(n_dot_h, alpha)}, ggx, 5e-6 * ggx)
                << alpha << " " << n_dot_h;
        }
}

// The projected microfacet area equals the macrosurface's (Walter et al. 2007, Section 3.1).
TEST(DistributionLaws, ProjectedAreaOfTheMicrofacetsIsOneForEveryWidth) {
    for (const auto distribution : {tables::Distribution::ggx, tables::Distribution::beckmann,
                                    tables::Distribution::blinn_phong}) {
        Terms<double> terms{{.distribution = distribution}};
        for (const double alpha : {0.003, 0.01, 0.1, 0.36, 0.7, 1.0}) {
            const double area =
                over_polar_cosine([&](double c) { return terms.slot_distribution(c, alpha) * c; });
            // 2e4 midpoints; d_beckmann cuts below cos 0.01, whose share is under 1e-8.
            EXPECT_NEAR(area, 1.0, 1e-5)
                << "distribution " << static_cast<int>(distribution) << " alpha " << alpha;
        }
    }
}

// Walter et al. 2007, Eq. 33 at the pole.
TEST(DistributionLaws, PeakOfGgxAndOfBeckmannIsOneOverPiAlphaSquared) {
    Terms<double> terms;
    for (const double alpha : {0.0025, 0.04, 0.5, 1.0}) {
        EXPECT_DOUBLE_EQ(terms.d_ggx(1.0, alpha) * test::pi * alpha * alpha, 1.0);
        EXPECT_DOUBLE_EQ(terms.d_beckmann(1.0, alpha) * test::pi * alpha * alpha, 1.0);
    }
}

TEST(DistributionLaws, IsFiniteAndNotNegativeAtEveryEdgeInFloat) {
    for (const auto distribution : {tables::Distribution::ggx, tables::Distribution::beckmann,
                                    tables::Distribution::blinn_phong}) {
        Terms<float> terms{{.distribution = distribution}};
        for (const float alpha : {0.0F, 1e-4F, 0.0025F, 1.0F})
            for (const float n_dot_h : {0.0F, 1e-6F, 0.5F, 0.9999999F, 1.0F}) {
                const float d = terms.slot_distribution(n_dot_h, alpha);
                EXPECT_TRUE(std::isfinite(d) && d >= 0.0F)
                    << static_cast<int>(distribution) << " alpha " << alpha << " n.h " << n_dot_h
                    << ": " << d;
            }
    }
}

}  // namespace
}  // namespace facet::brdf
