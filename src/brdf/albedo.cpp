// How much a surface reflects in all.
// SPDX-License-Identifier: MIT
#include "brdf/albedo.h"

#include <algorithm>
#include <cmath>

#include "brdf/terms.h"

namespace facet::brdf {
namespace {

constexpr std::uint32_t table_size = 32;  // ALBEDO_TABLE_SIZE of glsl/brdf/prelude.glsl
constexpr std::uint32_t table_points = 24;
constexpr std::uint32_t diffuse_points = 16;
constexpr double smallest_cosine = 1e-3;  // the table's edge stands in for grazing light
constexpr double smallest_alpha = 1e-4;
constexpr double two_pi = 6.283185307179586;

template <class Real>
using Vec3 = glm::vec<3, Real>;

/// A visible normal of GGX with width `alpha` (Dupuy & Benyoub 2023, Section 3, spherical caps). u in [0, 1)^2.
template <class Real>
Vec3<Real> visible_normal(const Vec3<Real>& v, Real alpha, Real u1, Real u2) {
    const Vec3<Real> stretched = glm::normalize(Vec3<Real>(alpha * v.x, alpha * v.y, v.z));
    const Real phi = static_cast<Real>(two_pi) * u1;
    const Real z = (Real(1) - u2) * (Real(1) + stretched.z) - stretched.z;
    const Real sine = std::sqrt(std::max(Real(0), Real(1) - z * z));
    const Vec3<Real> h = Vec3<Real>(sine * std::cos(phi), sine * std::sin(phi), z) + stretched;
    return glm::normalize(Vec3<Real>(alpha * h.x, alpha * h.y, h.z));
}

/// Density of `visible_normal`'s reflected direction: G1(v) D(h) / (4 n.v) (Walter et al. 2007, Eq. 38; Heitz 2018).
template <class Real>
Real visible_pdf(Terms<Real>& terms, Real n_dot_v, Real n_dot_h, Real alpha) {
    const Real a2 = alpha * alpha;
    const Real lambda = (std::sqrt(Real(1) + a2 * (Real(1) / (n_dot_v * n_dot_v) - Real(1))) - Real(1)) / 2;
    return terms.d_ggx(n_dot_h, alpha) / ((Real(1) + lambda) * Real(4) * n_dot_v);
}

/// Midpoints of GGX's visible normals, whatever the distribution: Beckmann's tails are shorter, so the quotient
/// stays bounded. By symmetry half of the azimuths suffice.
template <class Real>
SplitSum integrate(const tables::BrdfChoice& choice, Real n_dot_v, Real roughness, std::uint32_t side) {
    Terms<Real> terms{choice};
    const Real alpha = std::max(static_cast<Real>(smallest_alpha), terms.slot_width(roughness));
    const Vec3<Real> v(std::sqrt(std::max(Real(0), Real(1) - n_dot_v * n_dot_v)), 0, n_dot_v);
    const Real step = Real(1) / static_cast<Real>(side);
    double a = 0.0;
    double b = 0.0;
    for (std::uint32_t i = 0; i < side; ++i)
        for (std::uint32_t j = 0; j < side; ++j) {
            const Real u1 = (static_cast<Real>(i) + Real(0.5)) * step * Real(0.5);
            // u2 = t^2 (3 - 2t), du2 = 6t (1 - t) dt: points crowd where the lobe meets the horizon and its tail.
            const Real t = (static_cast<Real>(j) + Real(0.5)) * step;
            const Real u2 = t * t * (Real(3) - Real(2) * t);
            const Vec3<Real> h = visible_normal(v, alpha, u1, u2);
            const Real v_dot_h = glm::dot(v, h);
            const Real n_dot_l = Real(2) * v_dot_h * h.z - v.z;
            if (n_dot_l <= Real(0) || v_dot_h <= Real(0)) continue;
            const Real n_dot_h = std::min(Real(1), h.z);
            const Real f = terms.slot_distribution(n_dot_h, alpha) *
                           terms.slot_masking(n_dot_v, n_dot_l, roughness, alpha);
            const Real pdf = visible_pdf(terms, n_dot_v, n_dot_h, alpha);
            const auto weight = static_cast<double>(f * n_dot_l / pdf * Real(6) * t * (Real(1) - t));
            // Schlick's (1 - v.h)^5 split off, so that F0 can multiply what is left.
            const auto c = static_cast<double>(Real(1) - std::min(Real(1), v_dot_h));
            const double grazing = choice.fresnel == tables::Fresnel::none ? 1.0 : c * c * c * c * c;
            a += weight * (1.0 - grazing);
            b += weight * grazing;
        }
    const double count = static_cast<double>(side) * static_cast<double>(side);
    return {a / count, b / count};
}

/// Albedo of the white diffuse lobe: cosine-weighted midpoints, f pi averaged.
float diffuse_albedo(const tables::BrdfChoice& choice, float n_dot_v, float roughness) {
    if (choice.diffuse != tables::Diffuse::burley) return choice.diffuse == tables::Diffuse::none ? 0.0F : 1.0F;
    Terms<float> terms{choice};
    const float sin_v = std::sqrt(std::max(0.0F, 1.0F - n_dot_v * n_dot_v));
    const float step = 1.0F / static_cast<float>(diffuse_points);
    float sum = 0.0F;
    for (std::uint32_t i = 0; i < diffuse_points; ++i)
        for (std::uint32_t j = 0; j < diffuse_points; ++j) {
            const float n_dot_l = std::sqrt((static_cast<float>(i) + 0.5F) * step);
            const float phi = (static_cast<float>(j) + 0.5F) * step * static_cast<float>(two_pi) * 0.5F;
            const float sin_l = std::sqrt(std::max(0.0F, 1.0F - n_dot_l * n_dot_l));
            const float v_dot_l = sin_v * sin_l * std::cos(phi) + n_dot_v * n_dot_l;
            const float v_dot_h = std::sqrt(std::max(0.0F, (1.0F + v_dot_l) * 0.5F));
            sum += terms.slot_diffuse(Vec3<float>(1.0F), roughness, n_dot_v, n_dot_l, v_dot_h).x;
        }
    return sum * step * step * static_cast<float>(two_pi) * 0.5F;
}

/// 2 integral(E mu dmu) over a row stored at mu = x^2: 4 integral(E x^3 dx), by trapezia.
float row_average(const float* row, std::uint32_t size) {
    double sum = 0.0;
    const double step = 1.0 / static_cast<double>(size - 1);
    for (std::uint32_t i = 0; i < size; ++i) {
        const double x = static_cast<double>(i) * step;
        const double e = static_cast<double>(row[i * 4]) + static_cast<double>(row[i * 4 + 1]);
        sum += (i == 0 || i == size - 1 ? 0.5 : 1.0) * e * x * x * x;
    }
    return static_cast<float>(4.0 * sum * step);
}

}  // namespace

SplitSum split_sum(const tables::BrdfChoice& choice, double n_dot_v, double roughness, std::uint32_t side) {
    tables::BrdfChoice environment = choice;
    environment.masking = choice.environment_masking;
    return integrate<double>(environment, std::max(n_dot_v, smallest_cosine), roughness, side);
}

AlbedoTable albedo_table(const tables::BrdfChoice& choice) {
    tables::BrdfChoice environment = choice;
    environment.masking = choice.environment_masking;
    AlbedoTable table{.size = table_size, .texels = {}};
    table.texels.resize(std::size_t{table_size} * table_size * 4);
    const float step = 1.0F / static_cast<float>(table_size - 1);
    for (std::uint32_t y = 0; y < table_size; ++y) {
        float* row = &table.texels[std::size_t{y} * table_size * 4];
        const float roughness = static_cast<float>(y) * step;
        for (std::uint32_t x = 0; x < table_size; ++x) {
            const float root = static_cast<float>(x) * step;
            const float n_dot_v = std::max(root * root, static_cast<float>(smallest_cosine));
            const SplitSum sum = integrate<float>(environment, n_dot_v, roughness, table_points);
            row[x * 4] = static_cast<float>(sum.a);
            row[x * 4 + 1] = static_cast<float>(sum.b);
            row[x * 4 + 3] = diffuse_albedo(environment, n_dot_v, roughness);
        }
        const float average = row_average(row, table_size);
        for (std::uint32_t x = 0; x < table_size; ++x) row[x * 4 + 2] = average;
    }
    return table;
}

}  // namespace facet::brdf
