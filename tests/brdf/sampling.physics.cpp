// Drawing light directions: every sampler against its density, and both against the lobes they are
// for. SPDX-License-Identifier: MIT
#include "brdf/albedo.h"
#include "brdf/terms.h"
#include "support/directions.h"
#include "support/reference_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace facet::brdf {
namespace {

using tables::BrdfChoice;
using tables::Distribution;
using test::direction_of;
using test::PairOfDirections;
using Lobe = Terms<double>;
using Dir = Lobe::real3;

/// Uniform numbers whose sequence is the standard's (distributions are not).
class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double next() { return static_cast<double>(engine_()) / 4294967296.0; }
    Lobe::real2 pair() {
        const double x = next();
        return {x, next()};
    }

private:
    std::mt19937 engine_;
};

TEST(SamplingTables, DensitiesEqualTheTable) {
    for (const auto& row : test::reference_rows("pdf_points")) {
        const PairOfDirections at(row["n_dot_v"], row["n_dot_l"], row["phi"]);
        Lobe lobe;
        const double alpha = row["alpha"];
        EXPECT_NEAR(lobe.pdf_ggx(at.n_dot_v, at.n_dot_h, alpha), row["pdf_vndf"],
                    1e-9 * row["pdf_vndf"])
            << row.shown;
        EXPECT_NEAR(lobe.pdf_ndf(lobe.d_ggx(at.n_dot_h, alpha), at.n_dot_h, at.v_dot_h),
                    row["pdf_ndf"], 1e-9 * row["pdf_ndf"])
            << row.shown;
    }
}

/// One sampler of light directions with its density.
struct Sampler {
    const char* name;
    bool whole;  ///< draws no facet that is turned away from the viewer
    std::function<Dir(Lobe::real2 u, double lobe)> draw;
    std::function<double(const Dir& l)> density;
};

/// Every sampler there is, seen from `v`: the half vectors of each distribution, the diffuse lobes,
/// and the model's choice between the two.
std::vector<Sampler> samplers(const Dir& v, double roughness, std::vector<Lobe>& lobes) {
    std::vector<Sampler> all;
    lobes.clear();
    lobes.reserve(8);
    const double alpha = roughness * roughness;
    // A facet that the viewer sees from behind sends no light: null.
    const auto reflected = [v](const Dir& h) {
        const double v_dot_h = glm::dot(v, h);
        return v_dot_h > 0 ? h * (2 * v_dot_h) - v : Dir(0.0);
    };
    const auto half = [v](const Dir& l) { return glm::normalize(v + l); };
    for (const auto& [name, distribution] : {std::pair{"ggx", Distribution::ggx},
                                             {"beckmann", Distribution::beckmann},
                                             {"blinn-phong", Distribution::blinn_phong}}) {
        lobes.push_back({{.distribution = distribution}});
        Lobe* lobe = &lobes.back();
        all.push_back(
            {name, distribution == Distribution::ggx,
             [=](Lobe::real2 u, double) { return reflected(lobe->slot_sample_half(v, alpha, u)); },
             [=](const Dir& l) {
                 const Dir h = half(l);
                 // No facet looks down: the terms take cosines from 0 on.
                 return h.z > 0 ? lobe->slot_pdf_reflected(v.z, h.z, glm::dot(v, h), alpha) : 0.0;
             }});
    }
    lobes.push_back({});
    Lobe* plain = &lobes.back();
    all.push_back({"cosine", true,
                   [=](Lobe::real2 u, double) { return plain->slot_sample_diffuse(u); },
                   [=](const Dir& l) { return l.z > 0 ? plain->slot_pdf_diffuse(l.z) : 0.0; }});
    all.push_back({"uniform", true, [=](Lobe::real2 u, double) { return plain->sample_uniform(u); },
                   [=](const Dir& l) { return plain->pdf_uniform(l.z); }});
    const Lobe::real2 widths(alpha, std::min(1.0, 2.5 * alpha));
    all.push_back({"anisotropic", true,
                   [=](Lobe::real2 u, double) {
                       return reflected(plain->sample_ggx_anisotropic(v, widths, u));
                   },
                   [=](const Dir& l) {
                       const Dir h = half(l);
                       return h.z > 0 ? plain->pdf_ggx_anisotropic(v, h, widths) : 0.0;
                   }});
    const auto split = split_sum({}, v.z, roughness);
    const auto view = plain->brdf_view(plain->brdf_surface(Dir(0.8, 0.4, 0.1), 0.3, roughness), v.z,
                                       {split.a, split.b, average_albedo({}, roughness), 1.0});
    const auto sampler = plain->brdf_sampler(view, v);
    all.push_back(
        {"model", true,
         [=](Lobe::real2 u, double lobe) { return plain->brdf_sample(view, sampler, u, lobe); },
         [=](const Dir& l) {
             const Dir h = half(l);
             return h.z > 0
                        ? plain->brdf_pdf(view, sampler, std::max(l.z, 0.0), h.z, glm::dot(v, h))
                        : 0.0;
         }});
    return all;
}

constexpr int rings = 16;
constexpr int sectors = 24;
constexpr std::size_t bin_count = rings * sectors;

/// Bins of equal cosine (of the whole sphere: facets send some light down) and azimuth.
std::size_t bin_of(const Dir& l) {
    const double phi = std::atan2(l.y, l.x) / (2 * test::pi) + 0.5;
    const int ring = std::clamp(static_cast<int>((l.z * 0.5 + 0.5) * rings), 0, rings - 1);
    const int sector = std::clamp(static_cast<int>(phi * sectors), 0, sectors - 1);
    return static_cast<std::size_t>(ring * sectors + sector);
}

/// The density's integral over each bin, by midpoints, `side` squared a bin.
std::vector<double> expected_shares(const Sampler& sampler, int side) {
    std::vector<double> shares(bin_count);
    for (int ring = 0; ring < rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector) {
            double sum = 0;
            for (int i = 0; i < side; ++i)
                for (int j = 0; j < side; ++j) {
                    const double z = (ring + (i + 0.5) / side) / rings * 2 - 1;
                    const double phi = ((sector + (j + 0.5) / side) / sectors - 0.5) * 2 * test::pi;
                    sum += sampler.density(direction_of<Dir>(z, phi));
                }
            const double area = 2.0 / rings * 2 * test::pi / sectors;
            shares[static_cast<std::size_t>(ring * sectors + sector)] = sum / (side * side) * area;
        }
    return shares;
}

/// The value that chi-square of `freedom` degrees exceeds with probability 1 % (Wilson & Hilferty
/// 1931: its cube root is close to normal; 2.326 is the normal's 99th percentile).
double chi_square_bound(double freedom) {
    const double term = 2.0 / (9.0 * freedom);
    return freedom * std::pow(1.0 - term + 2.326 * std::sqrt(term), 3.0);
}

TEST(Sampling, DrawsFollowTheirDensityByChiSquareAtOnePercent) {
    constexpr int draws = 100'000;
    std::vector<Lobe> lobes;
    for (const double roughness : {0.35, 0.6, 1.0})
        for (const double cosine : {0.15, 0.6, 0.99})
            for (const Sampler& s : samplers(direction_of<Dir>(cosine, 0.4), roughness, lobes)) {
                // Facets seen edge on send light to -v with a density without bound, which
                // midpoints cannot sum.
                if (!s.whole && cosine < 0.5) continue;
                std::vector<double> counts(bin_count);
                Random random(17);
                for (int i = 0; i < draws; ++i) {
                    const auto u = random.pair();
                    const Dir l = s.draw(u, random.next());
                    if (l != Dir(0.0)) counts[bin_of(l)] += 1;
                }
                const auto shares = expected_shares(s, 40);
                // Bins that expect fewer than 5 are pooled, as the test asks for.
                double statistic = 0, pooled_count = 0, pooled_share = 0, freedom = -1;
                for (std::size_t i = 0; i < bin_count; ++i) {
                    const double expected = shares[i] * draws;
                    if (expected < 5) {
                        pooled_count += counts[i];
                        pooled_share += expected;
                        continue;
                    }
                    statistic += (counts[i] - expected) * (counts[i] - expected) / expected;
                    freedom += 1;
                }
                if (pooled_share >= 5) {
                    statistic += (pooled_count - pooled_share) * (pooled_count - pooled_share) /
                                 pooled_share;
                    freedom += 1;
                }
                EXPECT_LT(statistic, chi_square_bound(freedom))
                    << s.name << " roughness " << roughness << " n.v " << cosine << " freedom "
                    << freedom;
            }
}

TEST(Sampling, DensitiesIntegrateToOne) {
    std::vector<Lobe> lobes;
    for (const double roughness : {0.35, 0.6, 1.0})
        for (const double cosine : {0.15, 0.6, 1.0})
            for (const Sampler& s : samplers(direction_of<Dir>(cosine, 0.4), roughness, lobes)) {
                // Where facets turn away, the others' share is less than 1.
                if (!s.whole && cosine < 1.0) continue;
                double sum = 0;
                for (const double share : expected_shares(s, 60)) sum += share;
                EXPECT_NEAR(sum, 1.0, 1e-3)
                    << s.name << " roughness " << roughness << " n.v " << cosine;
            }
}

TEST(Sampling, SampledAlbedoEqualsQuadratureWithinThreeStandardErrors) {
    constexpr int draws = 40'000;
    for (const auto distribution : {Distribution::ggx, Distribution::beckmann})
        for (const double roughness : {0.1, 0.4, 1.0})
            for (const double cosine : {0.2, 0.7, 1.0}) {
                Lobe lobe{{.distribution = distribution}};
                const double alpha = roughness * roughness;
                const Dir v = direction_of<Dir>(cosine, 1.0);
                Random random(5);
                double sum = 0, squares = 0;
                for (int i = 0; i < draws; ++i) {
                    const Dir h = lobe.slot_sample_half(v, alpha, random.pair());
                    const double v_dot_h = glm::dot(v, h);
                    const Dir l = h * (2 * v_dot_h) - v;
                    if (l.z <= 0 || v_dot_h <= 0) continue;  // counts as 0
                    const double weight = lobe.slot_distribution(h.z, alpha) *
                                          lobe.slot_masking(v.z, l.z, roughness, alpha) * l.z /
                                          lobe.slot_pdf_reflected(v.z, h.z, v_dot_h, alpha);
                    sum += weight;
                    squares += weight * weight;
                }
                const double mean = sum / draws;
                const double error =
                    std::sqrt(std::max(0.0, squares / draws - mean * mean) / draws);
                const SplitSum exact = split_sum(lobe.choice, cosine, roughness);
                EXPECT_NEAR(mean, exact.a + exact.b, 3 * error + 2e-5)
                    << "roughness " << roughness << " n.v " << cosine;
            }
}

TEST(Sampling, AVisibleNormalsWeightNeverExceedsOne) {
    Lobe lobe;
    Random random(3);
    for (int i = 0; i < 20'000; ++i) {
        const double roughness = 0.03 + 0.97 * random.next();
        const double alpha = roughness * roughness;
        const Dir v = direction_of<Dir>(1e-3 + (1 - 1e-3) * random.next(), random.next() * 6.0);
        const Dir h = lobe.sample_ggx(v, alpha, random.pair());
        const double v_dot_h = glm::dot(v, h);
        const Dir l = h * (2 * v_dot_h) - v;
        if (l.z <= 0) continue;
        const double weight = lobe.d_ggx(h.z, alpha) *
                              lobe.v_smith_ggx_correlated(v.z, l.z, alpha) * l.z /
                              lobe.pdf_ggx(v.z, h.z, alpha);
        ASSERT_LE(weight, 1.0 + 1e-9) << "roughness " << roughness << " n.v " << v.z;
    }
}

}  // namespace
}  // namespace facet::brdf
