// The model that combines the terms: tables, energy, reciprocity.
// SPDX-License-Identifier: MIT
#include "brdf/albedo.h"
#include "brdf/sheen.h"
#include "brdf/terms.h"
#include "support/directions.h"
#include "support/reference_table.h"

#include <gtest/gtest.h>

namespace facet::brdf {
namespace {

using tables::BrdfChoice;
using tables::Distribution;
using tables::Fresnel;
using tables::Masking;
using tables::Multiscatter;
using test::PairOfDirections;
using test::reference_rows;
using Lobe = Terms<double>;
using Color = Lobe::real3;

/// What brdf_view takes, from quadrature instead of the table.
Lobe::real4 exact_albedo(const BrdfChoice& choice, double n_dot_v, double roughness) {
    const SplitSum sum = split_sum(choice, n_dot_v, roughness);
    return {sum.a, sum.b, average_albedo(choice, roughness), 1.0};
}

Lobe::BrdfView view_of(Lobe& lobe, Color base, double metallic, double roughness, double f0,
                       double n_dot_v) {
    Lobe::BrdfSurface surface = lobe.brdf_surface(base, metallic, roughness);
    surface.dielectric_f0 = Color(f0);
    return lobe.brdf_view(surface, n_dot_v, exact_albedo(lobe.choice, n_dot_v, roughness));
}

/// The choice that a model's name in the tables stands for; lights only.
BrdfChoice named(const std::string& model) {
    BrdfChoice choice{.multiscatter = Multiscatter::off};
    if (model == "ggx-separable") choice.masking = Masking::smith;
    if (model == "seed-direct") choice.masking = Masking::schlick_direct;
    if (model == "seed-ibl") choice.masking = Masking::schlick_ibl;
    if (model == "beckmann-correlated") choice.distribution = Distribution::beckmann;
    return choice;
}

TEST(ModelTables, CookTorranceEqualsTheTableForEveryModel) {
    for (const auto& row : reference_rows("brdf_points")) {
        Lobe lobe{named(row.texts.at("model"))};
        const PairOfDirections at(row["n_dot_v"], row["n_dot_l"], row["phi"]);
        Lobe::BrdfSurface surface =
            lobe.brdf_surface(Color(1.0), row["metallic"], row["roughness"]);
        surface.dielectric_f0 = Color(double(row["f0"]));
        const auto view = lobe.brdf_view(surface, at.n_dot_v, Lobe::real4(1.0));
        const auto value = lobe.brdf_light(view, at.n_dot_l, at.n_dot_h, at.v_dot_h, 1.0);
        // n.h is rebuilt from the angles, which costs digits in D where the lobe is narrow;
        // Beckmann's tails are subnormal numbers.
        EXPECT_NEAR(value.specular.x, row["specular"], 1e-6 * row["specular"] + 1e-300)
            << row.shown;
        EXPECT_NEAR(value.specular.x + value.diffuse.x, row["brdf"], 1e-6 * row["brdf"] + 1e-300)
            << row.shown;
    }
}

TEST(ModelTables, TheDefaultModelEqualsTheTable) {
    for (const auto& row : reference_rows("brdf_points_ms")) {
        Lobe lobe;
        const PairOfDirections at(row["n_dot_v"], row["n_dot_l"], row["phi"]);
        const auto view =
            view_of(lobe, Color(1.0), row["metallic"], row["roughness"], row["f0"], at.n_dot_v);
        const auto value = lobe.brdf_light(view, at.n_dot_l, at.n_dot_h, at.v_dot_h, 1.0);
        // The table's own error is 2e-5.
        EXPECT_NEAR(value.specular.x + value.diffuse.x, row["brdf"], 5e-5 * (1 + row["brdf"]))
            << row.shown;
        // Its specular column is one lobe whose F0 is mixed.
        const double f0 = row["f0"] + (1 - row["f0"]) * row["metallic"];
        const auto one = view_of(lobe, Color(f0), 1.0, row["roughness"], 0.0, at.n_dot_v);
        const auto lobe_value = lobe.brdf_light(one, at.n_dot_l, at.n_dot_h, at.v_dot_h, 1.0);
        EXPECT_NEAR(lobe_value.specular.x, row["specular"], 5e-5 * (1 + row["specular"]))
            << row.shown;
    }
}

TEST(ModelTables, CompensationOfEverySchemeEqualsTheTable) {
    for (const auto& row : reference_rows("furnace_specular")) {
        Lobe lobe;
        const Color f0(row["f0"]);
        const auto e = exact_albedo({}, row["n_dot_v"], row["roughness"]);
        const double e_v = e.x + e.y;
        const double single = row["f0"] * e.x + e.y;
        EXPECT_NEAR(single, row["single_scatter"], 3e-5) << row.shown;
        EXPECT_NEAR(single * lobe.ms_turquin(f0, e_v).x, row["turquin"], 5e-5) << row.shown;
        EXPECT_NEAR(single + lobe.ms_kulla_conty(f0, e_v, e.z).x, row["kulla_conty"], 5e-5)
            << row.shown;
        EXPECT_NEAR(single + lobe.ms_fdez_aguera(f0, e.x, e.y).x, row["fdez_specular"], 5e-5)
            << row.shown;
    }
}

TEST(ModelTables, FurnaceOfMetalnessEqualsTheTableInEnvironmentLight) {
    for (const auto& row : reference_rows("furnace_metalness")) {
        Lobe conserving;
        const auto restored = conserving.brdf_environment(view_of(
            conserving, Color(1.0), row["metallic"], row["roughness"], 0.04, row["n_dot_v"]));
        EXPECT_NEAR(restored.diffuse.x + restored.specular.x, row["compensated_per_lobe"], 1e-9)
            << row.shown;
        Lobe plain{{.multiscatter = Multiscatter::off}};
        const auto lost = plain.brdf_environment(
            view_of(plain, Color(1.0), row["metallic"], row["roughness"], 0.04, row["n_dot_v"]));
        // The mean Fresnel of the diffuse lobe is a fit, good to 1e-4.
        EXPECT_NEAR(lost.diffuse.x + lost.specular.x, row["lecture"], 2e-4) << row.shown;
    }
}

/// Albedo at n.v by summing brdf_light over the hemisphere: shares no formula with brdf/albedo.cpp.
Color summed(const BrdfChoice& choice, const Color& base, double metallic, double roughness,
             double n_dot_v) {
    Lobe lobe{choice};
    const auto view = view_of(lobe, base, metallic, roughness, 0.04, n_dot_v);
    const bool needs_e_l = choice.multiscatter == Multiscatter::kulla_conty;
    Color total(0.0);
    constexpr int side = 160;
    for (int i = 0; i < side; ++i) {
        const double n_dot_l = (i + 0.5) / side;
        const SplitSum e = needs_e_l ? split_sum(choice, n_dot_l, roughness) : SplitSum{1.0, 0.0};
        for (int j = 0; j < side; ++j) {
            const PairOfDirections at(n_dot_v, n_dot_l, (j + 0.5) * 180 / side);
            const auto value = lobe.brdf_light(view, at.n_dot_l, at.n_dot_h, at.v_dot_h, e.a + e.b);
            total = total + (value.diffuse + value.specular) * n_dot_l;
        }
    }
    return total * (2 * test::pi / (side * side));
}

TEST(ModelLaws, LightFromEverywhereComesBackWholeFromAWhiteSurface) {
    for (const auto multiscatter :
         {Multiscatter::on, Multiscatter::kulla_conty, Multiscatter::fdez_aguera})
        for (const double metallic : {0.0, 0.5, 1.0})
            for (const double roughness : {0.5, 1.0})
                for (const double n_dot_v : {0.1, 0.6, 1.0})
                    // The midpoint rule of 160 x 160 errs by 2e-3 on the narrowest lobe here, seen
                    // edge on.
                    EXPECT_NEAR(summed({.multiscatter = multiscatter}, Color(1.0), metallic,
                                       roughness, n_dot_v)
                                    .x,
                                1.0, 2e-3)
                        << static_cast<int>(multiscatter) << " metallic " << metallic
                        << " roughness " << roughness << " n.v " << n_dot_v;
}

TEST(ModelLaws, EnvironmentWeightsEqualTheSumOverLights) {
    const BrdfChoice choices[] = {
        {},
        {.masking = Masking::smith, .environment_masking = Masking::smith},
        {.distribution = Distribution::beckmann},
        {.diffuse = tables::Diffuse::eon},
        {.multiscatter = Multiscatter::off},
        {.multiscatter = Multiscatter::kulla_conty},
        {.multiscatter = Multiscatter::fdez_aguera},
        {.fresnel = Fresnel::none}};
    const Color base(0.9, 0.5, 0.1);
    for (const BrdfChoice& choice : choices)
        for (const double n_dot_v : {0.2, 0.8}) {
            Lobe lobe{choice};
            const auto weight = lobe.brdf_environment(view_of(lobe, base, 0.4, 0.7, 0.04, n_dot_v));
            const Color sum = summed(choice, base, 0.4, 0.7, n_dot_v);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR((weight.diffuse + weight.specular)[c], sum[c], 1e-3)
                    << "choice " << (&choice - choices) << " n.v " << n_dot_v << " channel " << c;
        }
}

// a and b are fitted so that the diffuse lobe gets what this Fresnel term, not Schlick's, leaves.
TEST(ModelLaws, AWhiteDielectricIsLosslessWithTheExactFresnelTermToo) {
    for (const double n_dot_v : {0.1, 0.5, 1.0})
        EXPECT_NEAR(summed({.fresnel = Fresnel::dielectric}, Color(1.0), 0.0, 0.6, n_dot_v).x, 1.0,
                    2e-3)
            << n_dot_v;
}

// f = k_d f_diffuse + k_s D G / (4 n.v n.l), and the added lobe where compensation has one.
TEST(ModelLaws, TheTermsShownAreWhatALightsValueIsMadeOf) {
    for (const auto multiscatter : {Multiscatter::on, Multiscatter::off, Multiscatter::kulla_conty})
        for (const double metallic : {0.0, 0.4, 1.0}) {
            Lobe lobe{{.multiscatter = multiscatter}};
            const Color base(0.9, 0.5, 0.1);
            const double roughness = 0.5;
            const PairOfDirections at(0.6, 0.7, 150.0);
            const auto view = view_of(lobe, base, metallic, roughness, 0.05, at.n_dot_v);
            const auto value = lobe.brdf_light(view, at.n_dot_l, at.n_dot_h, at.v_dot_h, 0.8);
            const auto terms = lobe.brdf_terms(view, at.n_dot_l, at.n_dot_h, at.v_dot_h);
            const Color added = view.added * lobe.slot_added_shape(0.8, view.e_average);
            const double d_v = terms.d * terms.g / (4.0 * at.n_dot_v * at.n_dot_l);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(terms.k_d[c] * base[c] / Lobe::PI, value.diffuse[c], 1e-12);
                EXPECT_NEAR(terms.k_s[c] * d_v + added[c], value.specular[c], 1e-12);
                EXPECT_GE(terms.f[c], 0.05 * (1.0 - metallic) + base[c] * metallic);
            }
        }
}

// Whatever a dielectric reflects, the diffuse lobe gets the rest: a white one loses nothing.
TEST(ModelLaws, AWhiteDielectricOfAnyIndexAndStrengthLosesNothing) {
    Lobe lobe;
    for (const double f0 : {0.0, 0.02, 0.17, 0.6, 1.0})
        for (const double specular : {0.0, 0.4, 1.0})
            for (const double roughness : {0.1, 0.6, 1.0})
                for (const double n_dot_v : {0.1, 0.5, 1.0}) {
                    auto surface = lobe.brdf_surface(Color(1.0), 0.0, roughness);
                    surface.dielectric_f0 = Color(f0);
                    surface.specular = specular;
                    const auto view = lobe.brdf_view(surface, n_dot_v,
                                                     exact_albedo(lobe.choice, n_dot_v, roughness));
                    const auto weight = lobe.brdf_environment(view);
                    EXPECT_NEAR(weight.diffuse.x + weight.specular.x, 1.0, 1e-9)
                        << f0 << ' ' << specular << ' ' << roughness;
                    EXPECT_NEAR(view.k_d + weight.specular.x + view.added.x, 1.0, 1e-9);
                }
}

TEST(ModelLaws, ACoatOverAWhiteSurfaceLosesNothing) {
    Lobe lobe;
    for (const double coat_roughness : {0.5, 1.0})  // as above: narrower lobes need a finer rule
        for (const double strength : {0.4, 1.0})
            for (const double n_dot_v : {0.1, 0.5, 1.0}) {
                const auto view = view_of(lobe, Color(1.0), 0.5, 0.7, 0.04, n_dot_v);
                const auto e = exact_albedo({}, n_dot_v, coat_roughness);
                const auto coat = lobe.brdf_coat(strength, coat_roughness, n_dot_v, e.x, e.y);
                const auto below = lobe.below_coat(coat, lobe.brdf_environment(view));
                EXPECT_NEAR(below.diffuse.x + below.specular.x + coat.albedo, 1.0, 1e-9);
                double reflected = 0.0;  // by the coat, summed over lights
                constexpr int side = 160;
                for (int i = 0; i < side; ++i)
                    for (int j = 0; j < side; ++j) {
                        const double n_dot_l = (i + 0.5) / side;
                        const PairOfDirections at(n_dot_v, n_dot_l, (j + 0.5) * 180 / side);
                        reflected +=
                            lobe.coat_light(coat, at.n_dot_l, at.n_dot_l, at.n_dot_h, at.v_dot_h) *
                            n_dot_l;
                    }
                EXPECT_NEAR(reflected * 2 * test::pi / (side * side), coat.albedo, 2e-3)
                    << "roughness " << coat_roughness << " n.v " << n_dot_v;
            }
}

TEST(ModelLaws, SheenUnderACoatOverAWhiteSurfaceGainsNothing) {
    Lobe lobe;
    for (const double roughness : {0.1, 0.3, 0.6, 1.0})
        for (const double n_dot_v : {0.02, 0.1, 0.5, 1.0}) {
            const double e =
                double{sheen_albedo(static_cast<float>(n_dot_v), static_cast<float>(roughness))};
            const auto sheen = lobe.brdf_sheen(Color(1.0), roughness, e);
            const auto view = view_of(lobe, Color(1.0), 0.5, 0.7, 0.04, n_dot_v);
            const auto below = lobe.below_sheen(sheen, lobe.brdf_environment(view), sheen.albedo);
            EXPECT_NEAR(below.diffuse.x + below.specular.x, 1.0, 1e-9);
            const auto ab = exact_albedo({}, n_dot_v, 0.4);
            const auto coat = lobe.brdf_coat(0.8, 0.4, n_dot_v, ab.x, ab.y);
            const auto whole = lobe.below_coat(coat, below);
            EXPECT_NEAR(whole.diffuse.x + whole.specular.x + coat.albedo, 1.0, 1e-9);
            double reflected = 0.0;  // by the fibres, summed over lights
            constexpr int side = 400;
            for (int i = 0; i < side; ++i)
                for (int j = 0; j < side; ++j) {
                    const double root = (i + 0.5) / side;  // dense at grazing angles
                    const double n_dot_l = root * root * root;
                    const PairOfDirections to(n_dot_v, n_dot_l, (j + 0.5) * 180 / side);
                    reflected += lobe.sheen_light(sheen, n_dot_v, n_dot_l, to.n_dot_h).x * n_dot_l *
                                 3 * root * root;
                }
            // The table is 0.03 off between its columns where the albedo falls steepest.
            EXPECT_NEAR(reflected * 2 * test::pi / (side * side), sheen.albedo.x, 0.03)
                << "roughness " << roughness << " n.v " << n_dot_v;
        }
}

TEST(ModelLaws, IsReciprocalWhereItClaimsToBe) {
    for (const auto multiscatter : {Multiscatter::off, Multiscatter::kulla_conty}) {
        Lobe lobe{{.multiscatter = multiscatter}};
        const auto specular = [&](const PairOfDirections& at) {
            const auto view = view_of(lobe, Color(0.8), 1.0, 0.7, 0.04, at.n_dot_v);
            const SplitSum e = split_sum(lobe.choice, at.n_dot_l, 0.7);
            return lobe.brdf_light(view, at.n_dot_l, at.n_dot_h, at.v_dot_h, e.a + e.b).specular.x;
        };
        for (const double phi : {0.0, 100.0, 180.0}) {
            const double forth = specular(PairOfDirections(0.2, 0.9, phi));
            EXPECT_NEAR(specular(PairOfDirections(0.9, 0.2, phi)), forth, 1e-12 + 1e-12 * forth);
        }
    }
}

TEST(ModelLaws, EveryChoiceIsFiniteAndNotNegativeAtEveryEdgeInFloat) {
    using Narrow = Terms<float>;
    for (const auto distribution : {Distribution::ggx, Distribution::beckmann})
        for (const auto masking :
             {Masking::smith_correlated, Masking::schlick_direct, Masking::none})
            for (const auto fresnel :
                 {Fresnel::schlick, Fresnel::dielectric, Fresnel::conductor, Fresnel::none})
                for (const auto multiscatter :
                     {Multiscatter::on, Multiscatter::off, Multiscatter::kulla_conty,
                      Multiscatter::fdez_aguera})
                    for (const float roughness : {0.05F, 1.0F})
                        for (const double v : {1e-3, 1.0})
                            for (const double l : {0.0, 1e-3, 1.0})
                                for (const double phi : {0.0, 180.0}) {
                                    Narrow lobe{{.distribution = distribution,
                                                 .masking = masking,
                                                 .fresnel = fresnel,
                                                 .multiscatter = multiscatter}};
                                    const auto s = lobe.brdf_surface({1, 0, 0.5F}, 0.5F, roughness);
                                    const auto view = lobe.brdf_view(s, static_cast<float>(v),
                                                                     {0.9F, 0.1F, 1.0F, 1.0F});
                                    const PairOfDirections at(v, l, phi);
                                    const auto value = lobe.brdf_light(
                                        view, static_cast<float>(l), static_cast<float>(at.n_dot_h),
                                        static_cast<float>(at.v_dot_h), 1.0F);
                                    for (int c = 0; c < 3; ++c) {
                                        const float x = value.diffuse[c] + value.specular[c];
                                        ASSERT_TRUE(std::isfinite(x) && x >= 0.0F)
                                            << x << " roughness " << roughness << " n.v " << v
                                            << " n.l " << l;
                                    }
                                }
}

}  // namespace
}  // namespace facet::brdf
