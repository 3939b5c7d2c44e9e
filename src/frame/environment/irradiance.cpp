// Diffuse light of an environment as nine spherical-harmonic coefficients.
// SPDX-License-Identifier: MIT
#include "frame/environment/irradiance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace facet::frame {
namespace {

using math::Vec3;
using Sh = std::array<Vec3, 9>;
using DVec3 = glm::dvec3;
constexpr double pi = 3.14159265358979323846;

/// Integrals over a row of pixels, from polar angle `top` to `bottom`, of the parts of the basis
/// that depend on the polar angle alone, times sin(theta): 1, cos, cos^2, sin, sin cos, sin^2.
struct PolarIntegrals {
    double one, cos1, cos2, sin1, sin_cos, sin2;
};
PolarIntegrals polar_integrals(double top, double bottom) {
    const auto primitive = [](double a) {
        const double c = std::cos(a);
        const double s = std::sin(a);
        return PolarIntegrals{.one = -c,
                              .cos1 = 0.5 * s * s,
                              .cos2 = -c * c * c / 3.0,
                              .sin1 = 0.5 * (a - s * c),
                              .sin_cos = s * s * s / 3.0,
                              .sin2 = c * c * c / 3.0 - c};
    };
    const PolarIntegrals a = primitive(top);
    const PolarIntegrals b = primitive(bottom);
    return {b.one - a.one,   b.cos1 - a.cos1,       b.cos2 - a.cos2,
            b.sin1 - a.sin1, b.sin_cos - a.sin_cos, b.sin2 - a.sin2};
}

/// Moments of one row with the rotation and the width of a pixel put in: radiance times 1, cos phi,
/// sin phi, cos 2 phi, sin 2 phi, integrated over phi.
std::array<DVec3, 5> turned(const AzimuthMoments& row, std::uint32_t width, double rotation_rad) {
    const auto vector = [&](int i) { return DVec3(row.sum[i][0], row.sum[i][1], row.sum[i][2]); };
    const double step = 2.0 * pi / width;
    const double first =
        2.0 * std::sin(step / 2.0);  // the integral of cos over a pixel, at its middle 1
    const double second = std::sin(step);
    const double c1 = std::cos(rotation_rad);
    const double s1 = std::sin(rotation_rad);
    const double c2 = std::cos(2.0 * rotation_rad);
    const double s2 = std::sin(2.0 * rotation_rad);
    // What stood at phi stands at phi - rotation.
    return {step * vector(0), first * (c1 * vector(1) + s1 * vector(2)),
            first * (c1 * vector(2) - s1 * vector(1)), second * (c2 * vector(3) + s2 * vector(4)),
            second * (c2 * vector(4) - s2 * vector(3))};
}

/// Integrals of radiance times 1, y, z, x, xy, yz, 3z^2 - 1, xz, x^2 - y^2.
std::array<DVec3, 9> basis_integrals(const Panorama& panorama, double rotation_rad) {
    std::array<DVec3, 9> sum{};
    for (std::uint32_t row = 0; row < panorama.height; ++row) {
        const double top = pi * row / panorama.height;
        const double bottom = pi * (row + 1.0) / panorama.height;
        const PolarIntegrals p = polar_integrals(top, bottom);
        const auto m = turned(panorama.moments[row], panorama.width, rotation_rad);
        // x = sin(theta) sin(phi), y = cos(theta), z = -sin(theta) cos(phi)
        const DVec3 xx = 0.5 * p.sin2 * (m[0] - m[3]);
        const DVec3 yy = p.cos2 * m[0];
        const DVec3 zz = 0.5 * p.sin2 * (m[0] + m[3]);
        sum[0] += p.one * m[0];
        sum[1] += p.cos1 * m[0];
        sum[2] -= p.sin1 * m[1];
        sum[3] += p.sin1 * m[2];
        sum[4] += p.sin_cos * m[2];
        sum[5] -= p.sin_cos * m[1];
        sum[6] += 3.0 * zz - p.one * m[0];
        sum[7] -= 0.5 * p.sin2 * m[4];
        sum[8] += xx - yy;
    }
    return sum;
}

/// Directions 6 degrees apart: between two, an order-2 function falls at most 0.3 % of its range
/// lower.
std::vector<Vec3> probe_directions() {
    std::vector<Vec3> out;
    for (int elevation = -90; elevation <= 90; elevation += 6)
        for (int azimuth = 0; azimuth < 360; azimuth += 6)
            out.push_back(
                math::direction_from(static_cast<float>(azimuth), static_cast<float>(elevation)));
    return out;
}

}  // namespace

Vec3 evaluate_irradiance(const Sh& sh, const Vec3& n) {
    return sh[0] + sh[1] * n.y + sh[2] * n.z + sh[3] * n.x + sh[4] * (n.x * n.y) +
           sh[5] * (n.y * n.z) + sh[6] * (3.0F * n.z * n.z - 1.0F) + sh[7] * (n.x * n.z) +
           sh[8] * (n.x * n.x - n.y * n.y);
}

Sh windowed(const Sh& sh) {
    Vec3 least = sh[0];
    for (const Vec3& n : probe_directions()) least = glm::min(least, evaluate_irradiance(sh, n));
    // mean + k (least - mean) = 0; one k for all channels, or colours would shift.
    float kept = 1.0F;
    for (int c = 0; c < 3; ++c)
        if (least[c] < 0.0F) kept = std::min(kept, sh[0][c] / (sh[0][c] - least[c]));
    Sh out = sh;
    for (std::size_t i = 1; i < out.size(); ++i) out[i] *= kept;
    return out;
}

Sh irradiance_sh(const Panorama& panorama, float rotation_deg) {
    // A_l / pi (1, 2/3, 1/4) times the square of each basis function's constant.
    constexpr std::array<double, 9> factor = {1.0 / (4.0 * pi),
                                              2.0 / 3.0 * 3.0 / (4.0 * pi),
                                              2.0 / 3.0 * 3.0 / (4.0 * pi),
                                              2.0 / 3.0 * 3.0 / (4.0 * pi),
                                              0.25 * 15.0 / (4.0 * pi),
                                              0.25 * 15.0 / (4.0 * pi),
                                              0.25 * 5.0 / (16.0 * pi),
                                              0.25 * 15.0 / (4.0 * pi),
                                              0.25 * 15.0 / (16.0 * pi)};
    const auto integrals =
        basis_integrals(panorama, static_cast<double>(rotation_deg) * pi / 180.0);
    Sh sh{};
    for (std::size_t i = 0; i < 9; ++i) sh[i] = Vec3(integrals[i] * factor[i]);
    return windowed(sh);
}

}  // namespace facet::frame
