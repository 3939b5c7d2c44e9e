// The lobe of a prefiltered level, and a mixture that equals it.
// SPDX-License-Identifier: MIT
#include "frame/environment/lobe.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace facet::frame {
namespace {

using std::numbers::pi;
constexpr std::size_t angle_count = 256;
constexpr double first_angle_rad = 1e-3;

/// Evenly spaced in the logarithm: lobes are 0.02 to 1 rad wide.
double angle(std::size_t i) {
    const double x = (static_cast<double>(i) + 0.5) / angle_count;
    return first_angle_rad * std::pow(pi / first_angle_rad, x);
}
/// Solid angle of the ring that angle i stands for.
double ring_sr(std::size_t i) {
    const double step = std::log(pi / first_angle_rad) / angle_count;
    return 2.0 * pi * std::sin(angle(i)) * angle(i) * step;
}

}  // namespace

double lobe_weight(double theta_rad, double alpha) {
    const double n_dot_l = std::cos(theta_rad);
    if (n_dot_l <= 0.0) return 0.0;
    const double n_dot_h = std::cos(0.5 * theta_rad);
    const double denominator = n_dot_h * n_dot_h * (alpha * alpha - 1.0) + 1.0;
    return alpha * alpha / (denominator * denominator) * n_dot_l;
}

float lobe_cosine(float alpha) {
    constexpr int steps = 256;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        // h no further than 45 degrees off; even in tan^2, where D is widest.
        const double u = (i + 0.5) / steps;
        const double a2 = static_cast<double>(alpha) * static_cast<double>(alpha);
        // Share of D (n.h) below this angle: sin^2 / (sin^2 + a^2 cos^2) = u times that of 45
        // degrees.
        const double share = u / (1.0 + a2);
        const double tan2 = a2 * share / (1.0 - share);
        sum += (1.0 - tan2) / (1.0 + tan2) / steps;  // cos of twice the angle
    }
    return static_cast<float>(sum / (1.0 + static_cast<double>(alpha * alpha)));
}

LobeTable tabulate(const std::function<double(double)>& lobe) {
    LobeTable out;
    double sum = 0.0;
    for (std::size_t i = 0; i < angle_count; ++i) {
        out.push_back(lobe(angle(i)));
        sum += out.back() * ring_sr(i);
    }
    for (double& x : out) x /= sum;
    return out;
}

std::vector<float> mixture_of(const LobeTable& whole, std::span<const LobeTable> parts) {
    // Least squares of (mixture - whole) / (whole + floor): a highlight's skirt is a thousandth of
    // its peak, and a sun is thousands of times the sky.
    constexpr double floor_of_peak = 1e-4;
    const double floor = floor_of_peak * whole.front();
    const std::size_t n = parts.size();
    std::vector<double> normal(n * n, 0.0);
    std::vector<double> right(n, 0.0);
    for (std::size_t k = 0; k < angle_count; ++k) {
        const double w = angle(k) / ((whole[k] + floor) * (whole[k] + floor));
        for (std::size_t i = 0; i < n; ++i) {
            right[i] += w * parts[i][k] * whole[k];
            for (std::size_t j = 0; j < n; ++j) normal[i * n + j] += w * parts[i][k] * parts[j][k];
        }
    }
    // Coordinate descent on the half-space x >= 0: Franc, Hlavac & Navara 2005, "Sequential
    // coordinate-wise algorithm for the non-negative least squares problem".
    std::vector<double> x(n, 0.0);
    constexpr int sweeps = 2000;
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t i = 0; i < n; ++i) {
            double residual = right[i];
            for (std::size_t j = 0; j < n; ++j) residual -= normal[i * n + j] * x[j];
            x[i] = std::max(x[i] + residual / normal[i * n + i], 0.0);
        }
    double sum = 0.0;
    for (const double xi : x) sum += xi;
    std::vector<float> out;
    for (const double xi : x) out.push_back(static_cast<float>(xi / sum));
    return out;
}

}  // namespace facet::frame
