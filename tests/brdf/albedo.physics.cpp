// Directional albedo: quadrature and the table against independent numbers.
// SPDX-License-Identifier: MIT
#include "brdf/albedo.h"

#include "brdf/terms.h"
#include "support/reference_table.h"

#include <gtest/gtest.h>

namespace facet::brdf {
namespace {

using tables::BrdfChoice;
using tables::Distribution;
using tables::Masking;
using tables::Width;
using test::reference_rows;

// 2e-5 is the quadrature's own, 1.5e-5 the worst of the tables'.
constexpr double quadrature_error = 4e-5;

BrdfChoice masked(Masking masking) { return {.masking = masking, .environment_masking = masking}; }

/// Compares E in `column` with the lobe of `choice`, over a whole table.
void expect_albedo(const std::string& table, const std::string& column, const BrdfChoice& choice,
                   double bound) {
    for (const auto& row : reference_rows(table)) {
        const SplitSum sum = split_sum(choice, row["n_dot_v"], row["roughness"]);
        EXPECT_NEAR(sum.a + sum.b, row[column], bound) << column << " " << row.shown;
    }
}

TEST(AlbedoTables, AlbedoEqualsTheTablesForEveryMasking) {
    expect_albedo("albedo_ggx_smith", "E_correlated", {}, quadrature_error);
    expect_albedo("albedo_ggx_smith", "E_separable", masked(Masking::smith), quadrature_error);
    expect_albedo("albedo_seed", "E_direct", masked(Masking::schlick_direct), quadrature_error);
    expect_albedo("albedo_seed", "E_ibl", masked(Masking::schlick_ibl), quadrature_error);
    expect_albedo("albedo_beckmann", "E", {.distribution = Distribution::beckmann},
                  quadrature_error);
}

TEST(AlbedoTables, AlbedoOfTheLecturesLetterEqualsTheTableAndGainsEnergy) {
    BrdfChoice literal = masked(Masking::schlick_direct);
    literal.width = Width::literal;
    expect_albedo("albedo_seed", "E_direct_literal", literal, quadrature_error);
    literal.environment_masking = Masking::schlick_ibl;
    expect_albedo("albedo_seed", "E_ibl_literal", literal, quadrature_error);
    const SplitSum grazing = split_sum(literal, 0.02, 0.3);
    EXPECT_GT(grazing.a + grazing.b, 2.0);
}

TEST(AlbedoTables, SplitSumEqualsTheTables) {
    const std::pair<const char*, BrdfChoice> sets[] = {
        {"split_sum", {}},
        {"split_sum_seed_ibl", masked(Masking::schlick_ibl)},
        {"albedo_beckmann", {.distribution = Distribution::beckmann}}};
    for (const auto& [name, choice] : sets)
        for (const auto& row : reference_rows(name)) {
            const SplitSum sum = split_sum(choice, row["n_dot_v"], row["roughness"]);
            EXPECT_NEAR(sum.a, row["A"], quadrature_error) << row.shown;
            EXPECT_NEAR(sum.b, row["B"], quadrature_error) << row.shown;
        }
}

TEST(AlbedoTables, AverageEqualsTheTable) {
    const std::pair<const char*, BrdfChoice> sets[] = {
        {"ggx_correlated", {}},
        {"ggx_separable", masked(Masking::smith)},
        {"seed_direct", masked(Masking::schlick_direct)},
        {"seed_ibl", masked(Masking::schlick_ibl)},
        {"beckmann", {.distribution = Distribution::beckmann}}};
    for (const auto& [column, choice] : sets)
        for (const auto& row : reference_rows("albedo_average"))
            EXPECT_NEAR(average_albedo(choice, row["roughness"]), row[column], 1e-4)
                << column << " " << row.shown;
}

// At alpha 1 and normal incidence the integral has a closed form: 1 - ln 2.
TEST(AlbedoLaws, IsOneMinusLogTwoAtFullRoughnessSeenFromAbove) {
    for (const Masking masking : {Masking::smith_correlated, Masking::smith,
                                  Masking::schlick_direct, Masking::schlick_ibl}) {
        const SplitSum sum = split_sum(masked(masking), 1.0, 1.0);
        EXPECT_NEAR(sum.a + sum.b, 1.0 - std::log(2.0), 1e-6) << static_cast<int>(masking);
    }
}

TEST(AlbedoLaws, AMirrorReflectsAll) {
    for (const double n_dot_v : {0.1, 0.5, 1.0}) {
        const SplitSum sum = split_sum({}, n_dot_v, 0.0);
        EXPECT_NEAR(sum.a + sum.b, 1.0, 1e-4) << n_dot_v;
        EXPECT_NEAR(sum.b, std::pow(1.0 - n_dot_v, 5.0), 1e-4) << n_dot_v;
    }
}

/// The table as a shader reads it: linear filter, edges clamped.
Terms<double>::real4 look_up(const AlbedoTable& table, double n_dot_v, double roughness) {
    Terms<double> terms;
    const auto at = terms.albedo_coordinates(n_dot_v, roughness);
    const double x = at.x * table.size - 0.5;
    const double y = at.y * table.size - 0.5;
    const auto column = std::min(static_cast<std::size_t>(x), std::size_t{table.size} - 2);
    const auto line = std::min(static_cast<std::size_t>(y), std::size_t{table.size} - 2);
    const auto texel = [&](std::size_t i, std::size_t j) {
        const float* t = &table.texels[(j * table.size + i) * 4];
        return Terms<double>::real4(t[0], t[1], t[2], t[3]);
    };
    const double fx = x - static_cast<double>(column);
    const double fy = y - static_cast<double>(line);
    return (texel(column, line) * (1 - fx) + texel(column + 1, line) * fx) * (1 - fy) +
           (texel(column, line + 1) * (1 - fx) + texel(column + 1, line + 1) * fx) * fy;
}

// The bounds are those that albedo.h promises; places lie between the table's own.
TEST(AlbedoTable, LooksUpWhatQuadratureGives) {
    const AlbedoTable table = albedo_table({});
    ASSERT_EQ(table.texels.size(), std::size_t{table.size} * table.size * 4);
    double sum_of_errors = 0;
    int count = 0;
    for (int i = 0; i < 24; ++i)
        for (int j = 0; j < 24; ++j) {
            const double roughness = 0.05 + 0.95 * (i + 0.37) / 24;
            const double n_dot_v = 0.01 + 0.99 * std::pow((j + 0.37) / 24, 2);
            const SplitSum exact = split_sum({}, n_dot_v, roughness);
            const auto found = look_up(table, n_dot_v, roughness);
            const double error = std::max({std::abs(found.x - exact.a), std::abs(found.y - exact.b),
                                           std::abs(found.x + found.y - exact.a - exact.b)});
            ASSERT_LT(error, n_dot_v < 0.1 ? 2.5e-3 : 1e-3)
                << "roughness " << roughness << " n.v " << n_dot_v;
            sum_of_errors += error;
            ++count;
        }
    EXPECT_LT(sum_of_errors / count, 3e-4);
}

TEST(AlbedoTable, HoldsTheAverageInEveryColumn) {
    const AlbedoTable table = albedo_table({});
    for (const double roughness : {0.1, 0.4, 0.7, 1.0}) {
        const double exact = average_albedo({}, roughness);
        for (const double n_dot_v : {0.05, 0.5, 1.0})
            EXPECT_NEAR(look_up(table, n_dot_v, roughness).z, exact, 5e-4) << roughness;
    }
}

TEST(AlbedoTable, HoldsTheAlbedoOfBurleysLobe) {
    const AlbedoTable table = albedo_table({.diffuse = tables::Diffuse::burley});
    for (const auto& row : reference_rows("albedo_sheen_diffuse"))
        EXPECT_NEAR(look_up(table, row["n_dot_v"], row["roughness"]).w, row["burley"], 2e-3)
            << row.shown;
}

TEST(AlbedoTable, IsTheEnvironmentsLobeInTheLecturesSet) {
    const AlbedoTable table = albedo_table({.masking = Masking::schlick_direct,
                                            .environment_masking = Masking::schlick_ibl,
                                            .multiscatter = tables::Multiscatter::off});
    for (const auto& row : reference_rows("split_sum_seed_ibl")) {
        const auto found = look_up(table, row["n_dot_v"], row["roughness"]);
        const double bound = row["n_dot_v"] < 0.1 ? 2.5e-3 : 1e-3;
        EXPECT_NEAR(found.x, row["A"], bound) << row.shown;
        EXPECT_NEAR(found.y, row["B"], bound) << row.shown;
    }
}

}  // namespace
}  // namespace facet::brdf
