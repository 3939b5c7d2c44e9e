// Cosines of a pair of directions, and sums over the hemisphere.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace facet::test {

inline constexpr double pi = 3.14159265358979323846;

/// What a BRDF takes, from n.v, n.l and the azimuth between them (180 degrees: the mirror side).
struct PairOfDirections {
    double n_dot_v;
    double n_dot_l;
    double v_dot_l;
    double n_dot_h;
    double v_dot_h;

    PairOfDirections(double cos_v, double cos_l, double phi_deg) : n_dot_v(cos_v), n_dot_l(cos_l) {
        const double sines = std::sqrt((1 - cos_v * cos_v) * (1 - cos_l * cos_l));
        v_dot_l = cos_v * cos_l + sines * std::cos(phi_deg * pi / 180);
        // |v + l|^2 = 2 + 2 v.l, and h bisects the angle between v and l.
        v_dot_h = std::sqrt(std::max(0.0, (1 + v_dot_l) / 2));
        n_dot_h = v_dot_h > 0 ? std::min(1.0, (cos_v + cos_l) / (2 * v_dot_h)) : 0.0;
    }
};

/// The direction at that cosine to z and azimuth (radians).
template <class Vector>
Vector direction_of(double cosine, double phi) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

/// 2 pi integral of f(c) dc over c in [0, 1], by the midpoint rule in log(1 - c + 1e-9): points
/// crowd at the pole, where normal distributions peak, as narrow as alpha 1e-3.
template <class F>
double over_polar_cosine(F f, int count = 20000) {
    const double low = std::log(1e-9);
    const double high = std::log(1.0 + 1e-9);
    const double step = (high - low) / count;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const double from_pole = std::exp(low + (i + 0.5) * step);
        sum += f(1.0 - from_pole + 1e-9) * from_pole * step;
    }
    return 2 * pi * sum;
}

/// Integral of f(pair) cos over the light's hemisphere at one n.v: midpoints in n.l^2 and azimuth.
/// For lobes as wide as diffuse ones.
template <class F>
double over_light_hemisphere(double n_dot_v, F f, int side = 400) {
    double sum = 0;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const PairOfDirections at(n_dot_v, (i + 0.5) / side, (j + 0.5) * 180 / side);
            sum += f(at) * at.n_dot_l;
        }
    return 2 * pi * sum / (side * side);
}

}  // namespace facet::test
