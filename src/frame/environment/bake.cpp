// Image-based light, baked on the CPU from a lat-long picture.
// SPDX-License-Identifier: MIT
#include "frame/environment/bake.h"

#include "frame/environment/cube_pyramid.h"
#include "frame/environment/irradiance.h"
#include "frame/environment/panorama.h"
#include "frame/environment/prefilter.h"
#include "math/half.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace facet::frame {
namespace {

// At 4 the edge of a half-sphere lobe around a sun shows as steps.
constexpr std::uint32_t last_level_px = 8;

/// Mean over the sphere and the channels.
double mean_nit(const image::Image& latlong) {
    const auto pixels = latlong.as<float>();
    const std::size_t width = latlong.size.width;
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t y = 0; y < latlong.size.height; ++y) {
        const double weight =
            std::sin((static_cast<double>(y) + 0.5) / latlong.size.height * 3.14159265358979323846);
        double row = 0.0;
        for (std::size_t i = y * width * 3; i < (y + 1) * width * 3; ++i)
            row += static_cast<double>(pixels[i]);
        sum += weight * row;
        weights += weight * 3.0 * static_cast<double>(width);
    }
    return sum / weights;
}

/// Irradiance over pi is at most four times the mean; a channel may hold three times the mean of
/// all.
float unit_for(const image::Image& latlong, float intensity) {
    const double most = 12.0 * mean_nit(latlong) * static_cast<double>(intensity);
    if (!(most > static_cast<double>(math::half_max))) return 1.0F;
    return static_cast<float>(
        std::exp2(std::ceil(std::log2(most / static_cast<double>(math::half_max)))));
}

std::vector<std::uint16_t> halves_of(const CubeMip& mip) {
    const std::size_t side = mip.side;
    std::vector<std::uint16_t> out(6 * side * side * 4);
    for (std::uint32_t face = 0; face < 6; ++face)
        for (std::size_t row = 0; row < side; ++row)
            store_halves(&mip.at(face, row, 0), side, out.data() + (face * side + row) * side * 4);
    return out;
}

}  // namespace

std::uint32_t baked_level_count(std::uint32_t face_px) {
    return static_cast<std::uint32_t>(std::countr_zero(face_px / last_level_px)) + 1;
}

void warn_of(const BakedEnvironment& baked, base::Warnings& warnings) {
    if (!baked.overflowed) return;
    warnings.push_back(
        {.file = {},
         .where = "environment",
         .what = "radiance above the largest half float is cut in reflections",
         .found = fmt::format("more than {:.0f} nit", math::half_max * baked.unit_nit),
         .remedy = "lower --env-intensity"});
}

BakedEnvironment bake_environment(const image::Image& latlong, float rotation_deg, float intensity,
                                  base::ThreadPool& pool) {
    BakedEnvironment out;
    // 256 for 1024x512: at a face's middle its texels are 1.3 pixels of the picture, at its corners
    // 0.6.
    const std::uint32_t wanted =
        std::clamp(latlong.size.height / 2, baked_face_min_px, baked_face_max_px);
    out.face_px = std::bit_ceil(wanted);
    out.unit_nit = unit_for(latlong, intensity);
    const Panorama panorama = make_panorama(latlong, intensity / out.unit_nit, pool);
    out.irradiance = halves_of(
        irradiance_over_pi(panorama, rotation_deg, BakedEnvironment::irradiance_px, pool));
    CubePyramid pyramid = make_cube_pyramid(panorama, out.face_px, rotation_deg, pool);
    out.overflowed = pyramid.overflowed;
    std::vector<CubeMip> maps = prefilter(pyramid, baked_level_count(out.face_px), pool);
    for (const CubeMip& map : maps) out.radiance.push_back(halves_of(map));
    maps.erase(maps.begin(), maps.begin() + BakedEnvironment::first_kept - 1);
    out.kept = std::move(maps);
    out.radiance.insert(out.radiance.begin(), std::move(pyramid.level0));
    return out;
}

}  // namespace facet::frame
