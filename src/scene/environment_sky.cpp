// Clear sky and sun (Preetham, Shirley & Smits 1999).
// SPDX-License-Identifier: MIT
#include "math/color.h"
#include "scene/environment_models.h"

#include <algorithm>
#include <cmath>

namespace facet::scene {
namespace {

using math::Vec3;

constexpr float nit_scale = 1e-4F;
constexpr float extraterrestrial_lux = 133'800.0F;
constexpr float smallest_cosine = 0.02F;  // Perez's 1 / cos at the horizon

/// CIE xyY to linear Rec.709.
Vec3 rgb_from_yxy(float luminance, float x, float y) {
    return math::rec709_from_xyz({x / y * luminance, luminance, (1.0F - x - y) / y * luminance});
}

/// Zenith chromaticity, appendix A.2: a cubic in the sun's zenith angle, quadratic in turbidity.
float zenith_chromaticity(const float (&m)[3][4], float turbidity, float theta) {
    const float powers[4] = {theta * theta * theta, theta * theta, theta, 1.0F};
    const float t[3] = {turbidity * turbidity, turbidity, 1.0F};
    float sum = 0.0F;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) sum += t[row] * m[row][column] * powers[column];
    return sum;
}

/// Share of sunlight that reaches the ground, by channel: Rayleigh and aerosols (appendix A.1), at
/// 680, 550, 440 nm.
Vec3 transmittance(float sun_elevation_deg, float turbidity) {
    const float zenith_deg = 90.0F - sun_elevation_deg;
    const float mass = 1.0F / (std::cos(glm::radians(zenith_deg)) +
                               0.15F * std::pow(93.885F - zenith_deg, -1.253F));
    const float beta = 0.04608F * turbidity - 0.04586F;
    Vec3 out;
    const float wavelengths_um[3] = {0.68F, 0.55F, 0.44F};
    for (int c = 0; c < 3; ++c) {
        const float rayleigh = 0.008735F * std::pow(wavelengths_um[c], -4.08F);
        const float aerosol = beta * std::pow(wavelengths_um[c], -1.3F);
        out[c] = std::exp(-(rayleigh + aerosol) * mass);
    }
    return out;
}

}  // namespace

// F(theta, gamma) = (1 + A e^(B / cos theta)) (1 + C e^(D gamma) + E cos^2 gamma)         (Perez et
// al. 1993)
float Sky::Perez::gradient(float cos_theta) const {
    return 1.0F + a * std::exp(b / std::max(cos_theta, smallest_cosine));
}
float Sky::Perez::indicatrix(float gamma, float cos_gamma) const {
    return 1.0F + c * std::exp(d * gamma) + e * cos_gamma * cos_gamma;
}

Sky::Sky(const SkyParameters& p) {
    const float t = p.turbidity;
    perez_[0] = {0.1787F * t - 1.4630F, -0.3554F * t + 0.4275F, -0.0227F * t + 5.3251F,
                 0.1206F * t - 2.5771F, -0.0670F * t + 0.3703F};
    perez_[1] = {-0.0193F * t - 0.2592F, -0.0665F * t + 0.0008F, -0.0004F * t + 0.2125F,
                 -0.0641F * t - 0.8989F, -0.0033F * t + 0.0452F};
    perez_[2] = {-0.0167F * t - 0.2608F, -0.0950F * t + 0.0092F, -0.0079F * t + 0.2102F,
                 -0.0441F * t - 1.6537F, -0.0109F * t + 0.0529F};
    to_sun_ = math::direction_from(p.sun_azimuth_deg, p.sun_elevation_deg);
    const float theta = glm::radians(90.0F - p.sun_elevation_deg);
    const float chi = (4.0F / 9.0F - t / 120.0F) * (math::pi - 2.0F * theta);
    const float zenith_kcd = (4.0453F * t - 4.9710F) * std::tan(chi) - 0.2155F * t + 2.4192F;
    constexpr float mx[3][4] = {{0.00166F, -0.00375F, 0.00209F, 0.0F},
                                {-0.02903F, 0.06377F, -0.03202F, 0.00394F},
                                {0.11693F, -0.21196F, 0.06052F, 0.25886F}};
    constexpr float my[3][4] = {{0.00275F, -0.00610F, 0.00317F, 0.0F},
                                {-0.04214F, 0.08970F, -0.04153F, 0.00516F},
                                {0.15346F, -0.26756F, 0.06670F, 0.26688F}};
    zenith_ = {std::max(zenith_kcd, 0.05F) * 1000.0F * nit_scale, zenith_chromaticity(mx, t, theta),
               zenith_chromaticity(my, t, theta)};
    for (int i = 0; i < 3; ++i)
        zenith_[i] /= perez_[i].gradient(1.0F) * perez_[i].indicatrix(theta, std::cos(theta));
    sun_illuminance_ = transmittance(p.sun_elevation_deg, t) * (extraterrestrial_lux * nit_scale);
    measure_ground(p.ground_albedo);
}

Vec3 Sky::sky_radiance(const Row& row, const Vec3& d) const {
    const float cos_gamma = std::clamp(math::dot(d, to_sun_), -1.0F, 1.0F);
    const float gamma = std::acos(cos_gamma);
    Vec3 yxy;
    for (int i = 0; i < 3; ++i) yxy[i] = row.gradient[i] * perez_[i].indicatrix(gamma, cos_gamma);
    return glm::max(rgb_from_yxy(yxy.x, yxy.y, yxy.z), Vec3(0.0F));
}

/// Lambert ground under the sky's and the sun's illuminance; a coarse midpoint sum is exact enough
/// for it.
void Sky::measure_ground(float albedo) {
    Vec3 illuminance(0.0F);
    constexpr int rings = 16;
    constexpr int sectors = 32;
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < sectors; ++s) {
            const float y = std::sqrt((static_cast<float>(r) + 0.5F) / rings);  // cosine-weighted
            const float a = (static_cast<float>(s) + 0.5F) / sectors * 2.0F * math::pi;
            const float h = std::sqrt(1.0F - y * y);
            illuminance += sky_radiance(row(y), {h * std::sin(a), y, h * std::cos(a)});
        }
    illuminance *= math::pi / (rings * sectors);
    illuminance += sun_illuminance_ * std::max(to_sun_.y, 0.0F);
    ground_radiance_ = illuminance * (albedo / math::pi);
}

Sky::Row Sky::row(float y) const {
    // Half a degree of haze joins sky and ground, so that no reflection shows a knife edge.
    Row out{.ground = std::clamp(0.5F - y / 0.01F, 0.0F, 1.0F), .gradient = {}};
    for (int i = 0; i < 3; ++i) out.gradient[i] = zenith_[i] * perez_[i].gradient(y);
    return out;
}

Vec3 Sky::radiance(const Row& row, const Vec3& d) const {
    Vec3 radiance = ground_radiance_ * row.ground;
    if (row.ground < 1.0F) radiance += sky_radiance(row, d) * (1.0F - row.ground);
    return radiance;
}

}  // namespace facet::scene
