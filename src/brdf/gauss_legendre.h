// Gauss-Legendre quadrature on [0, 1].
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace facet::brdf {

/// Points and weights; the weights sum to 1. Exact for polynomials up to degree 2 count - 1.
struct Quadrature {
    std::vector<double> points;
    std::vector<double> weights;
};

/// Roots of the Legendre polynomial by Newton's iteration (Davis & Rabinowitz 1984, Section 2.7.3).
[[nodiscard]] inline Quadrature gauss_legendre(std::size_t count) {
    constexpr double pi = 3.14159265358979323846;
    const auto n = static_cast<double>(count);
    Quadrature rule;
    for (std::size_t i = 0; i < count; ++i) {
        double x = std::cos(pi * (static_cast<double>(i) + 0.75) / (n + 0.5));
        double slope = 1.0;
        for (int step = 0; step < 8; ++step) {  // quadratic convergence from a start good to 1e-3
            double value = 1.0;
            double before = 0.0;
            for (double k = 0.0; k < n; k += 1.0) {
                const double older = before;
                before = value;
                value = ((2.0 * k + 1.0) * x * before - k * older) / (k + 1.0);
            }
            slope = n * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        rule.points.push_back(0.5 * (1.0 - x));
        rule.weights.push_back(1.0 / ((1.0 - x * x) * slope * slope));
    }
    return rule;
}

}  // namespace facet::brdf
