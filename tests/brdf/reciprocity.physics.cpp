// Helmholtz: exchanging view and light changes nothing, for every model that claims it
// (physics: 1.5). SPDX-License-Identifier: MIT
#include "brdf/query.h"
#include "brdf/terms.h"
#include "support/directions.h"

#include <gtest/gtest.h>

namespace facet::brdf {
namespace {

using tables::BrdfChoice;
using test::PairOfDirections;

template <class Enum>
Enum value(std::size_t index) {
    return static_cast<Enum>(index);
}

/// Every combination of terms that is reciprocal: those without a factor that knows the view alone.
std::vector<BrdfChoice> reciprocal_choices() {
    std::vector<BrdfChoice> all;
    for (std::size_t d = 0; d < 3; ++d)
        for (std::size_t m = 0; m < 5; ++m)
            for (std::size_t f = 0; f < 5; ++f)
                for (std::size_t l = 0; l < 4; ++l)
                    all.push_back({.distribution = value<tables::Distribution>(d),
                                   .masking = value<tables::Masking>(m),
                                   .environment_masking = value<tables::Masking>(m),
                                   .fresnel = value<tables::Fresnel>(f),
                                   .diffuse = value<tables::Diffuse>(l),
                                   .multiscatter = tables::Multiscatter::off});
    return all;
}

TEST(Reciprocity, HoldsForEveryUncompensatedModelToOneInTenBillion) {
    for (const BrdfChoice& choice : reciprocal_choices()) {
        Queries queries(choice);
        for (const double roughness : {0.1, 0.5, 1.0})
            for (const double phi : {0.0, 75.0, 180.0})
                for (const auto& [v, l] : {std::pair{0.05, 0.9}, {0.4, 0.7}, {0.98, 0.3}}) {
                    const QuerySurface from_v{roughness, 0.4, 0.04, 0.8, v};
                    const QuerySurface from_l{roughness, 0.4, 0.04, 0.8, l};
                    const double forth = queries.value(QueryTerm::full, from_v, l, phi);
                    const double back = queries.value(QueryTerm::full, from_l, v, phi);
                    EXPECT_NEAR(back, forth, 1e-10 * std::max(1.0, forth))
                        << static_cast<int>(choice.distribution) << static_cast<int>(choice.masking)
                        << static_cast<int>(choice.fresnel) << static_cast<int>(choice.diffuse)
                        << " roughness " << roughness;
                }
    }
}

// Kulla and Conty's lobe is reciprocal; the diffuse lobe below it, scaled by what the specular one
// leaves at v, is not.
TEST(Reciprocity, HoldsForKullaAndContysSpecularLobe) {
    Queries queries({.multiscatter = tables::Multiscatter::kulla_conty});
    for (const double phi : {0.0, 120.0, 180.0}) {
        const double forth =
            queries.value(QueryTerm::model_specular, {0.7, 1.0, 0.04, 0.8, 0.2}, 0.9, phi);
        EXPECT_NEAR(queries.value(QueryTerm::model_specular, {0.7, 1.0, 0.04, 0.8, 0.9}, 0.2, phi),
                    forth, 1e-10 * forth);
    }
}

// The default is labelled as not reciprocal (physics: 6.1), and this is how far it is off at worst
// here.
TEST(Reciprocity, OfTheDefaultModelIsBrokenByItsCompensationAlone) {
    Queries queries(BrdfChoice{});
    const double forth = queries.value(QueryTerm::full, {1.0, 1.0, 0.04, 1.0, 0.1}, 0.9, 180.0);
    const double back = queries.value(QueryTerm::full, {1.0, 1.0, 0.04, 1.0, 0.9}, 0.1, 180.0);
    EXPECT_GT(std::abs(forth - back), 1e-3);
    {
        const double e_forth = queries.albedo(0.1, 1.0).a + queries.albedo(0.1, 1.0).b;
        const double e_back = queries.albedo(0.9, 1.0).a + queries.albedo(0.9, 1.0).b;
        EXPECT_NEAR(forth * e_forth, back * e_back, 1e-10);
    }
}

}  // namespace
}  // namespace facet::brdf
