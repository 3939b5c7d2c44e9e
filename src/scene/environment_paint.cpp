// Lat-long pictures painted from a function of direction.
// SPDX-License-Identifier: MIT
#include "scene/environment_paint.h"

#include <algorithm>
#include <numbers>

namespace facet::scene {

using math::Vec3;

namespace {
using std::numbers::pi;
}

LatLong::LatLong(math::Extent size) : size_(size) {
    for (std::uint32_t x = 0; x < size.width; ++x) {
        const double turn = (x + 0.5) / size.width - 0.5;
        const double phi = turn * 2.0 * pi;
        columns_.emplace_back(std::sin(phi), std::cos(phi));
    }
    for (std::uint32_t y = 0; y < size.height; ++y) {
        const double theta = (y + 0.5) / size.height * pi;
        rows_.emplace_back(std::sin(theta), std::cos(theta));
    }
}

float LatLong::solid_angle_sr(std::size_t row) const noexcept {
    const float half_row = 0.5F * math::pi / static_cast<float>(size_.height);
    const float column = 2.0F * math::pi / static_cast<float>(size_.width);
    return column * 2.0F * rows_[row].x * std::sin(half_row);
}

void add_disc(image::Image& picture, const LatLong& map, const Vec3& to_sun, float radius_rad,
              const Vec3& illuminance_lux) {
    std::vector<std::size_t> covered;
    const std::size_t width = map.size().width;
    const std::size_t height = map.size().height;
    const float sun_row =
        std::acos(std::clamp(to_sun.y, -1.0F, 1.0F)) / math::pi * static_cast<float>(height);
    // A disc smaller than a pixel still covers the one it falls into.
    const float pixel_rad = math::pi / static_cast<float>(height);
    const float reach = std::cos(std::max(radius_rad, 0.75F * pixel_rad));
    const float reach_rows = std::max(radius_rad / pixel_rad, 1.0F) + 1.0F;
    const auto first = static_cast<std::size_t>(std::max(sun_row - reach_rows, 0.0F));
    const auto last = std::min(static_cast<std::size_t>(sun_row + reach_rows) + 1, height);
    float facing_sr = 0.0F;  // solid angle, times the cosine to the surface that faces the sun
    for (std::size_t row = first; row < last; ++row)
        for (std::size_t column = 0; column < width; ++column) {
            const float cosine = math::dot(map.direction(column, row), to_sun);
            if (cosine < reach) continue;
            covered.push_back(row * width + column);
            facing_sr += map.solid_angle_sr(row) * cosine;
        }
    const auto values = picture.as<float>();
    for (const std::size_t pixel : covered)
        for (int c = 0; c < 3; ++c)
            values[pixel * 3 + static_cast<std::size_t>(c)] += illuminance_lux[c] / facing_sr;
}

}  // namespace facet::scene
