// Fresnel terms: tables, and their values at the ends of the angle.
// SPDX-License-Identifier: MIT
#include "brdf/terms.h"
#include "support/reference_table.h"

#include <gtest/gtest.h>

namespace facet::brdf {
namespace {

using tables::Fresnel;
using test::reference_rows;
using Color = Terms<double>::real3;

constexpr double fresnel_digits = 1e-9;  // absolute; the tables have ten digits of numbers up to 1

TEST(FresnelTables, SchlickEqualsTheTable) {
    Terms<double> terms;
    for (const auto& row : reference_rows("f_schlick"))
        EXPECT_NEAR(terms.f_schlick(Color(row["f0"]), row["u"]).x, row["F"], fresnel_digits)
            << row.shown;
}

TEST(FresnelTables, DielectricEqualsTheTableFromBothSides) {
    Terms<double> terms;
    for (const auto& row : reference_rows("f_dielectric"))
        EXPECT_NEAR(terms.f_dielectric(row["u"], row["eta"]), row["F"], fresnel_digits)
            << row.shown;
}

TEST(FresnelTables, ConductorEqualsTheTable) {
    Terms<double> terms;
    for (const auto& row : reference_rows("f_conductor"))
        EXPECT_NEAR(terms.f_conductor(row["u"], row["n"], row["k"]), row["F"], fresnel_digits)
            << row.shown;
}

TEST(FresnelTables, F82EqualsTheTable) {
    Terms<double> terms;
    for (const auto& row : reference_rows("f_f82"))
        EXPECT_NEAR(terms.f_f82(Color(row["f0"]), Color(row["tint"]), row["u"]).x, row["F"],
                    fresnel_digits)
            << row.shown;
}

TEST(FresnelTables, IndexFromF0InvertsTheReflectanceAtNormalIncidence) {
    Terms<double> terms;
    int compared = 0;
    for (const auto& row : reference_rows("ior_f0")) {
        const double eta = row["n2"] / row["n1"];
        if (eta < 1) continue;  // the same F0 belongs to eta and 1/eta; the index is the dense one
        EXPECT_NEAR(terms.ior_from_f0(row["F0"]), eta, 1e-7) << row.shown;
        ++compared;
    }
    EXPECT_GT(compared, 5);
}

TEST(FresnelLaws, EveryTermIsF0AtNormalIncidenceAndOneAtGrazing) {
    for (const Fresnel fresnel :
         {Fresnel::schlick, Fresnel::dielectric, Fresnel::conductor, Fresnel::f82}) {
        Terms<double> terms{{.fresnel = fresnel}};
        // Not 0: a conductor that reflects nothing there is vacuum, at every angle.
        for (const double f0 : {0.02, 0.04, 0.5, 0.95, 0.999}) {
            EXPECT_NEAR(terms.slot_fresnel(Color(f0), Color(1.0), 1.0).x, f0, 1e-12)
                << static_cast<int>(fresnel);
            EXPECT_NEAR(terms.slot_fresnel(Color(f0), Color(1.0), 0.0).x, 1.0, 1e-12)
                << static_cast<int>(fresnel) << " F0 " << f0;
        }
    }
}

// Radiance inside is spread over eta^2 less solid angle: (1 - F_in average) = (1 - F_out average) /
// eta^2, the averages weighted with the cosine.
TEST(FresnelLaws, LightThatEntersEqualsLightThatLeavesOverTheSquaredIndex) {
    Terms<double> terms;
    const auto average = [&](double eta) {
        constexpr int count = 200000;
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            const double u = (i + 0.5) / count;
            sum += 2 * u * terms.f_dielectric(u, eta) / count;
        }
        return sum;
    };
    for (const double eta : {1.2, 1.5, 2.42})
        EXPECT_NEAR(1 - average(1 / eta), (1 - average(eta)) / (eta * eta), 1e-6) << eta;
}

// With no absorption a conductor is a dielectric.
TEST(FresnelLaws, AConductorThatAbsorbsNothingIsADielectric) {
    Terms<double> terms;
    for (const double n : {1.2, 1.5, 2.42})
        for (double u = 0.05; u <= 1.0; u += 0.05)
            EXPECT_NEAR(terms.f_conductor(u, n, 0.0), terms.f_dielectric(u, n), 1e-12)
                << n << " " << u;
}

TEST(FresnelLaws, StaysBetweenNothingAndAllAtEveryEdgeInFloat) {
    for (const Fresnel fresnel :
         {Fresnel::schlick, Fresnel::dielectric, Fresnel::conductor, Fresnel::f82, Fresnel::none}) {
        Terms<float> terms{{.fresnel = fresnel}};
        for (const float f0 : {0.0F, 0.04F, 1.0F})
            for (const float u : {0.0F, 1e-6F, 0.5F, 0.9999999F, 1.0F}) {
                const float f =
                    terms.slot_fresnel(Terms<float>::real3(f0), Terms<float>::real3(0.5F), u).x;
                EXPECT_TRUE(f >= 0.0F && f <= 1.0F + 1e-6F)
                    << static_cast<int>(fresnel) << " F0 " << f0 << " u " << u << ": " << f;
            }
    }
}

}  // namespace
}  // namespace facet::brdf
