// Quadrature over half vectors: integrals over light directions that resolve lobes however narrow.
// SPDX-License-Identifier: MIT
#pragma once

#include "brdf/gauss_legendre.h"

#include <algorithm>
#include <cmath>

namespace facet::brdf {

/// One direction of the light and what it stands for: integral(f cos dl) ~ sum(f weight).
struct LightNode {
    double n_dot_l = 0.0;
    double n_dot_h = 0.0;
    double v_dot_h = 0.0;
    double weight = 0.0;  ///< sr, the cosine in it
};

/// The cosines of a light direction from v.l.
inline LightNode light_node(double n_dot_v, double n_dot_l, double v_dot_l, double weight = 0.0) {
    // |v + l|^2 = 2 + 2 v.l, and h bisects the angle between v and l.
    const double v_dot_h = std::sqrt(std::max(0.0, 0.5 + 0.5 * v_dot_l));
    const double n_dot_h =
        v_dot_h > 0.0 ? std::min(1.0, (n_dot_v + n_dot_l) / (2.0 * v_dot_h)) : 0.0;
    return {n_dot_l, n_dot_h, v_dot_h, weight};
}

/// Points per half turn of azimuth, and from the normal to the horizon.
struct HalfVectorRule {
    Quadrature azimuth;
    Quadrature inclination;
};

/// Calls `visit(LightNode)` for every point of the rule; dl = 4 (v.h) dh (Walter et al. 2007, Eq.
/// 14), up to where l meets the horizon. tan(theta) = alpha tan(x) makes GGX's density flat in
/// sin^2(x); x is held by q = tan(x/2), so that no point costs a sine; q = top s^2 (3 - 2s) crowds
/// points at the normal and at the horizon, where masking turns fast. The two quarter turns go
/// apart: seen edge on, facets that turn away end at a right angle.
template <class Visit>
void over_half_vectors(const HalfVectorRule& rule, double n_dot_v, double alpha,
                       const Visit& visit) {
    constexpr double pi = 3.14159265358979323846;
    const double sin_v = std::sqrt((1.0 - n_dot_v) * (1.0 + n_dot_v));
    for (std::size_t a = 0; a < rule.azimuth.points.size(); ++a)
        for (const double sign : {1.0, -1.0}) {
            const double side = sign * sin_v * std::cos(0.5 * pi * rule.azimuth.points[a]);
            // n.l = sqrt(side^2 + n_dot_v^2) cos(2 theta - atan2(side, n_dot_v))
            const double tan_horizon =
                std::tan(0.5 * std::atan2(side, n_dot_v) + 0.25 * pi) / alpha;
            const double top = tan_horizon / (1.0 + std::sqrt(1.0 + tan_horizon * tan_horizon));
            for (std::size_t i = 0; i < rule.inclination.points.size(); ++i) {
                const double s = rule.inclination.points[i];
                const double q = top * s * s * (3.0 - 2.0 * s);
                const double q2 = q * q;
                const double rise = alpha * 2.0 * q;  // tan(theta) = rise / run
                const double run = 1.0 - q2;
                const double scale = 1.0 / std::sqrt(rise * rise + run * run);
                const double n_dot_h = run * scale;
                const double sin_theta = rise * scale;
                const double v_dot_h = side * sin_theta + n_dot_v * n_dot_h;
                const double n_dot_l = 2.0 * v_dot_h * n_dot_h - n_dot_v;
                if (n_dot_l <= 0.0 || v_dot_h <= 0.0) continue;  // rounding at the horizon
                const double dq = top * 6.0 * s * (1.0 - s) * rule.inclination.weights[i];
                const double dtheta = alpha * 2.0 * (1.0 + q2) * scale * scale * dq;
                // Both halves of the turn are alike: 2 (pi / 2).
                visit(LightNode{
                    n_dot_l, n_dot_h, std::min(1.0, v_dot_h),
                    4.0 * v_dot_h * n_dot_l * sin_theta * dtheta * pi * rule.azimuth.weights[a]});
            }
        }
}

/// The same over the whole hemisphere of l, evenly by its projection: for lobes as wide as diffuse
/// ones.
template <class Visit>
void over_hemisphere(const HalfVectorRule& rule, double n_dot_v, const Visit& visit) {
    constexpr double pi = 3.14159265358979323846;
    const double sin_v = std::sqrt((1.0 - n_dot_v) * (1.0 + n_dot_v));
    for (std::size_t a = 0; a < rule.azimuth.points.size(); ++a)
        for (std::size_t i = 0; i < rule.inclination.points.size(); ++i) {
            const double n_dot_l = rule.inclination.points[i];
            const double sin_l = std::sqrt((1.0 - n_dot_l) * (1.0 + n_dot_l));
            const double v_dot_l =
                n_dot_v * n_dot_l + sin_v * sin_l * std::cos(pi * rule.azimuth.points[a]);
            visit(light_node(
                n_dot_v, n_dot_l, v_dot_l,
                2.0 * pi * n_dot_l * rule.azimuth.weights[a] * rule.inclination.weights[i]));
        }
}

}  // namespace facet::brdf
