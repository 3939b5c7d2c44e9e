// Diffuse lobes: tables, albedo, reciprocity.
// SPDX-License-Identifier: MIT
#include "brdf/terms.h"
#include "support/directions.h"
#include "support/reference_table.h"

#include <gtest/gtest.h>

namespace facet::brdf {
namespace {

using tables::Diffuse;
using test::PairOfDirections;
using test::reference_rows;
using Color = Terms<double>::real3;

double lobe(Diffuse diffuse, double color, double roughness, const PairOfDirections& at) {
    Terms<double> terms{{.diffuse = diffuse}};
    return terms.slot_diffuse(Color(color), roughness, at.n_dot_v, at.n_dot_l, at.v_dot_h).x;
}

TEST(DiffuseTables, BurleyAndEonEqualTheTable) {
    for (const auto& row : reference_rows("diffuse_points")) {
        const PairOfDirections at(row["n_dot_v"], row["n_dot_l"], row["phi"]);
        const double r = row["roughness"];
        EXPECT_NEAR(lobe(Diffuse::burley, 1.0, r, at), row["burley"], 1e-9) << row.shown;
        EXPECT_NEAR(lobe(Diffuse::eon, 1.0, r, at), row["eon_rho1"], 1e-8) << row.shown;
        EXPECT_NEAR(lobe(Diffuse::eon, 0.5, r, at), row["eon_rho0.5"], 1e-8) << row.shown;
    }
}

TEST(DiffuseTables, AlbedoOfBurleyEqualsTheTable) {
    for (const auto& row : reference_rows("albedo_sheen_diffuse")) {
        const double albedo = test::over_light_hemisphere(
            row["n_dot_v"],
            [&](const PairOfDirections& at) {
                return lobe(Diffuse::burley, 1.0, row["roughness"], at);
            },
            200);
        EXPECT_NEAR(albedo, row["burley"], 5e-5) << row.shown;  // the table's own error is 2e-5
    }
}

TEST(DiffuseLaws, AlbedoOfLambertIsTheColorAndOfEonIsOneForWhite) {
    for (const double n_dot_v : {0.05, 0.3, 0.8, 1.0}) {
        const auto albedo = [&](Diffuse diffuse, double color, double r) {
            return test::over_light_hemisphere(
                n_dot_v, [&](const PairOfDirections& at) { return lobe(diffuse, color, r, at); },
                200);
        };
        EXPECT_NEAR(albedo(Diffuse::lambert, 0.7, 1.0), 0.7, 1e-9);
        for (const double r : {0.2, 0.6, 1.0})
            // E and its average are exact; the kink at v.l = n.v n.l costs the midpoint rule a few
            // 1e-4.
            EXPECT_NEAR(albedo(Diffuse::eon, 1.0, r), 1.0, 5e-4) << "n.v " << n_dot_v << " r " << r;
    }
}

TEST(DiffuseLaws, ClosedFormAlbedoOfEonEqualsTheIntegralForEveryColor) {
    Terms<double> terms;
    for (const double n_dot_v : {0.1, 0.5, 1.0})
        for (const double color : {0.2, 0.8}) {
            const double albedo = test::over_light_hemisphere(
                n_dot_v,
                [&](const PairOfDirections& at) { return lobe(Diffuse::eon, color, 0.7, at); },
                200);
            EXPECT_NEAR(terms.diffuse_eon_albedo(Color(color), 0.7, n_dot_v).x, albedo, 5e-4)
                << n_dot_v;
        }
}

TEST(DiffuseLaws, IsTheSameWithViewAndLightExchanged) {
    for (const Diffuse diffuse : {Diffuse::lambert, Diffuse::burley, Diffuse::eon})
        for (const double phi : {0.0, 70.0, 180.0})
            EXPECT_DOUBLE_EQ(lobe(diffuse, 0.6, 0.8, PairOfDirections(0.2, 0.9, phi)),
                             lobe(diffuse, 0.6, 0.8, PairOfDirections(0.9, 0.2, phi)));
}

TEST(DiffuseLaws, IsFiniteAndNotNegativeAtEveryEdgeInFloat) {
    for (const Diffuse diffuse : {Diffuse::lambert, Diffuse::burley, Diffuse::eon, Diffuse::none}) {
        Terms<float> terms{{.diffuse = diffuse}};
        for (const float r : {0.0F, 1.0F})
            for (const double v : {0.0, 1e-6, 0.5, 1.0})
                for (const double l : {0.0, 1e-6, 0.5, 1.0})
                    for (const double phi : {0.0, 180.0}) {
                        const PairOfDirections at(v, l, phi);
                        const float f =
                            terms
                                .slot_diffuse(Terms<float>::real3(1.0F), r, static_cast<float>(v),
                                              static_cast<float>(l), static_cast<float>(at.v_dot_h))
                                .x;
                        EXPECT_TRUE(std::isfinite(f) && f >= 0.0F)
                            << static_cast<int>(diffuse) << " " << r << " " << v << " " << l << " "
                            << phi << ": " << f;
                    }
    }
}

}  // namespace
}  // namespace facet::brdf
