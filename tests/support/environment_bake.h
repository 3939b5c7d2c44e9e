// Building blocks of the tests of the environment's bake: pictures, look-ups, brute force.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/environment/bake.h"
#include "frame/environment/cube_mip.h"
#include "math/cube_map.h"
#include "math/half.h"

#include <cmath>
#include <functional>

namespace facet::frame {

using math::Vec3;
inline constexpr double pi = 3.14159265358979323846;

/// Radiance by direction, sampled at pixel centres: middle column -z, to the right +x (contract).
inline image::Image picture(std::uint32_t height,
                            const std::function<Vec3(const Vec3&)>& radiance) {
    image::Image out({2 * height, height}, 3, image::Sample::f32);
    auto pixels = out.as<float>();
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < 2 * height; ++x) {
            const double theta = (y + 0.5) / height * pi;
            const double phi = ((x + 0.5) / (2.0 * height) - 0.5) * 2.0 * pi;
            const Vec3 d(std::sin(phi) * std::sin(theta), std::cos(theta),
                         -std::cos(phi) * std::sin(theta));
            const Vec3 value = radiance(d);
            for (int c = 0; c < 3; ++c)
                pixels[(std::size_t{y} * 2 * height + x) * 3 + static_cast<std::size_t>(c)] =
                    value[c];
        }
    return out;
}

inline BakedEnvironment bake(const image::Image& latlong, float rotation_deg = 0.0F,
                             float intensity = 1.0F) {
    base::ThreadPool pool(2);
    return bake_environment(latlong, rotation_deg, intensity, pool);
}

inline Vec3 texel(const BakedEnvironment& baked, std::size_t level, std::size_t face,
                  std::size_t row, std::size_t column) {
    const std::size_t side = baked.face_px >> level;
    const std::uint16_t* p =
        baked.radiance[level].data() + ((face * side + row) * side + column) * 4;
    return {math::float_from_half(p[0]), math::float_from_half(p[1]), math::float_from_half(p[2])};
}
inline Vec3 texel_direction(const BakedEnvironment& baked, std::size_t level, std::size_t face,
                            std::size_t row, std::size_t column) {
    const auto side = static_cast<float>(baked.face_px >> level);
    return math::normalize(math::direction_from(math::CubePoint{
        static_cast<std::uint32_t>(face), (static_cast<float>(column) + 0.5F) / side * 2.0F - 1.0F,
        (static_cast<float>(row) + 0.5F) / side * 2.0F - 1.0F}));
}
/// What a level-0 look-up in `direction` returns, nearest texel.
inline Vec3 reflected(const BakedEnvironment& baked, const Vec3& direction) {
    const math::CubePoint p = math::cube_point_from(direction);
    const auto index = [&](float x) {
        return static_cast<std::size_t>((x + 1.0F) * 0.5F * static_cast<float>(baked.face_px) *
                                        0.9999F);
    };
    return texel(baked, 0, p.face, index(p.t), index(p.s));
}

/// E(n) / pi as the shader finds it: filtered across the edges of faces.
inline Vec3 irradiance_over_pi(const BakedEnvironment& baked, const Vec3& n) {
    const std::uint32_t side = BakedEnvironment::irradiance_px;
    CubeMip mip = make_mip(side);
    for (std::uint32_t face = 0; face < 6; ++face)
        for (std::size_t row = 0; row < side; ++row)
            for (std::size_t column = 0; column < side; ++column) {
                const std::uint16_t* p =
                    baked.irradiance.data() + ((face * side + row) * side + column) * 4;
                mip.at(face, row, column) =
                    Lanes{math::float_from_half(p[0]), math::float_from_half(p[1]),
                          math::float_from_half(p[2]), 0.0F};
            }
    fill_borders(mip);
    FourDirections d{};
    d.x[0] = n.x;
    d.y[0] = n.y;
    d.z[0] = n.z;
    for (std::size_t i = 1; i < 4; ++i) d.y[i] = 1.0F;
    const Lanes found = mip.sample(d)[0];
    return Vec3(found[0], found[1], found[2]) * baked.unit_nit;
}

/// Visits some texels of each level's every face.
inline void for_some_texels(
    const BakedEnvironment& baked,
    const std::function<void(std::size_t level, const Vec3& n, const Vec3& value)>& visit) {
    for (std::size_t level = 0; level < baked.radiance.size(); ++level) {
        const std::size_t side = baked.face_px >> level;
        for (std::size_t k = 0; k < 24; ++k) {
            const std::size_t row = (k * 37 + 11) % side;
            const std::size_t column = (k * 53 + 5) % side;
            visit(level, texel_direction(baked, level, k % 6, row, column),
                  texel(baked, level, k % 6, row, column));
        }
    }
}

/// D(h) (n.l), n = v = l (Walter et al. 2007, Eq. 33, without its constant).
inline double lobe(double cosine, double alpha) {
    if (cosine <= 0.0) return 0.0;
    const double q = 0.5 * (1.0 + cosine) * (alpha * alpha - 1.0) + 1.0;
    return cosine / (q * q);
}

/// The prefiltered value by summing over every pixel of the picture.
inline Vec3 brute_force(const image::Image& latlong, const Vec3& n, double alpha) {
    const auto pixels = latlong.as<float>();
    double sum[3] = {};
    double weights = 0.0;
    for (std::uint32_t y = 0; y < latlong.size.height; ++y) {
        const double theta = (y + 0.5) / latlong.size.height * pi;
        for (std::uint32_t x = 0; x < latlong.size.width; ++x) {
            const double phi = ((x + 0.5) / latlong.size.width - 0.5) * 2.0 * pi;
            const double cosine = static_cast<double>(n.x) * std::sin(phi) * std::sin(theta) +
                                  static_cast<double>(n.y) * std::cos(theta) -
                                  static_cast<double>(n.z) * std::cos(phi) * std::sin(theta);
            const double w = lobe(cosine, alpha) * std::sin(theta);
            weights += w;
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += w * static_cast<double>(
                                  pixels[(std::size_t{y} * latlong.size.width + x) * 3 + c]);
        }
    }
    return {static_cast<float>(sum[0] / weights), static_cast<float>(sum[1] / weights),
            static_cast<float>(sum[2] / weights)};
}

inline double alpha_of(const BakedEnvironment& baked, std::size_t level) {
    const double roughness =
        static_cast<double>(level) / static_cast<double>(baked.radiance.size() - 1);
    return roughness * roughness;
}

}  // namespace facet::frame
