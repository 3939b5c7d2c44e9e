// The samples of a picture as they add up.
// SPDX-License-Identifier: MIT
#include "trace/film.h"

#include "math/color.h"
#include "trace/aov.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

/// Slope of the sRGB encoding of a luminance that a screen shows; 0 above white, where nothing
/// changes.
double display_slope(double linear) {
    if (linear >= 1.0) return 0.0;
    if (linear <= 0.0031308) return 12.92;  // IEC 61966-2-1:1999, clause 4.2
    return 1.055 / 2.4 * std::pow(linear, 1.0 / 2.4 - 1.0);
}

}  // namespace

Film::Film(math::Extent size, std::vector<tables::Aov> paths)
    : size_(size),
      across_((size.width + tile_px - 1) / tile_px),
      down_((size.height + tile_px - 1) / tile_px),
      pixels_(static_cast<std::size_t>(size.pixels())),
      paths_(std::move(paths)),
      path_sums_(pixels_.size() * paths_.size() * 3) {}

bool Film::add(std::size_t pixel, const PathLight& light, const LightPaths& apart) {
    const math::Vec3& nit = light.radiance_nit;
    if (!std::isfinite(nit.x) || !std::isfinite(nit.y) || !std::isfinite(nit.z)) return false;
    PixelSums& sums = pixels_[pixel];
    sums.red += static_cast<double>(nit.x);
    sums.green += static_cast<double>(nit.y);
    sums.blue += static_cast<double>(nit.z);
    const auto y = static_cast<double>(math::luminance(nit));
    sums.luminance2 += y * y;
    sums.coverage += static_cast<double>(light.coverage);
    ++sums.count;
    for (std::size_t k = 0; k < paths_.size(); ++k) {
        const math::Vec3 value = aov_value(paths_[k], {}, apart);
        for (std::size_t c = 0; c < 3; ++c)
            path_sums_[(pixel * paths_.size() + k) * 3 + c] +=
                static_cast<double>(value[static_cast<int>(c)]);
    }
    return true;
}

std::vector<image::Layer> Film::mean_paths() const {
    std::vector<image::Layer> layers;
    for (std::size_t k = 0; k < paths_.size(); ++k) {
        image::Image mean(size_, 3, image::Sample::f32);
        const auto values = mean.as<float>();
        for (std::size_t i = 0; i < values.size(); ++i) {
            const PixelSums& sums = pixels_[i / 3];
            if (sums.count == 0) continue;
            const std::size_t at = (i / 3 * paths_.size() + k) * 3 + i % 3;
            values[i] = static_cast<float>(path_sums_[at] * (1.0 / sums.count));
        }
        const tables::AovRow& row = tables::row(paths_[k]);
        layers.push_back(image::layer_of(row.key, row.channels, std::move(mean)));
    }
    return layers;
}

image::Image Film::mean() const {
    image::Image out(size_, 4, image::Sample::f32);
    const auto values = out.as<float>();
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const PixelSums& sums = pixels_[i];
        if (sums.count == 0) continue;
        const double share = 1.0 / sums.count;
        values[i * 4] = static_cast<float>(sums.red * share);
        values[i * 4 + 1] = static_cast<float>(sums.green * share);
        values[i * 4 + 2] = static_cast<float>(sums.blue * share);
        // Ground that is lit more than without the scene covers less than nothing.
        values[i * 4 + 3] = static_cast<float>(std::max(sums.coverage * share, 0.0));
    }
    return out;
}

Film::TileBox Film::tile_box(std::size_t tile) const {
    const auto x = static_cast<std::uint32_t>(tile % across_) * tile_px;
    const auto y = static_cast<std::uint32_t>(tile / across_) * tile_px;
    return {x, y, std::min(x + tile_px, size_.width), std::min(y + tile_px, size_.height)};
}

double Film::squared_error(const TileBox& box, double exposure) const {
    double squares = 0.0;
    for (std::uint32_t y = box.y0; y < box.y1; ++y)
        for (std::uint32_t x = box.x0; x < box.x1; ++x) {
            const PixelSums& sums = pixels_[std::size_t{y} * size_.width + x];
            const double n = sums.count;
            if (n < 2) {
                squares += 1.0;
                continue;
            }
            const double mean = (0.2126 * sums.red + 0.7152 * sums.green + 0.0722 * sums.blue) / n;
            const double variance = std::max(0.0, sums.luminance2 / n - mean * mean) / (n - 1.0);
            const double slope = exposure * display_slope(exposure * mean);
            squares += std::min(1.0, variance * slope * slope);
        }
    return squares;
}

double Film::tile_error(std::size_t tile, double exposure) const {
    const TileBox box = tile_box(tile);
    return std::sqrt(squared_error(box, exposure) / ((box.x1 - box.x0) * (box.y1 - box.y0)));
}

double Film::error(double exposure) const {
    return std::sqrt(squared_error({0, 0, size_.width, size_.height}, exposure) /
                     static_cast<double>(size_.pixels()));
}

}  // namespace facet::trace
