// A lat-long picture made ready for sampling.
// SPDX-License-Identifier: MIT
#include "frame/environment/panorama.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace facet::frame {
namespace {

/// Above every light there is; keeps products with it finite in float.
constexpr float radiance_max_nit = 1e30F;

void read_row(std::span<const float> source, float intensity, Lanes* row) {
    const std::size_t width = source.size() / 3;
    for (std::size_t x = 0; x < width; ++x) {
        const float* p = source.data() + 3 * x;
        row[x] = Lanes{std::min(p[0] * intensity, radiance_max_nit),
                       std::min(p[1] * intensity, radiance_max_nit),
                       std::min(p[2] * intensity, radiance_max_nit), 0.0F};
    }
}

/// Averages `row` over a window of `columns` (at least 1 and at most the width), around the seam
/// too.
void blur_row(Lanes* row, std::size_t width, double columns) {
    // Differences of running sums; in double, because a sun stands in the same sum as the sky
    // beside it. The window starts `reach` + a part of a pixel before the middle of each pixel.
    const double half = columns / 2.0;
    const auto reach = static_cast<std::size_t>(std::ceil(half - 0.5));
    const double part =
        static_cast<double>(reach) + 0.5 - half;  // of the first and last pixel, left out
    std::vector<double> running(width + 2 * reach + 2);
    for (std::size_t lane = 0; lane < 3; ++lane) {
        double sum = 0.0;
        for (std::size_t i = 0; i < width + 2 * reach + 1; ++i) {
            running[i] = sum;
            sum += static_cast<double>(row[(i + width - reach) % width][lane]);
        }
        running.back() = sum;
        const auto at = [&](std::size_t i, double fraction) {
            return running[i] + fraction * (running[i + 1] - running[i]);
        };
        for (std::size_t x = 0; x < width; ++x)
            row[x][lane] = static_cast<float>(
                std::max((at(x + 2 * reach, 1.0 - part) - at(x, part)) / columns, 0.0));
    }
}

/// Rows beyond the poles: the way goes on over the pole and down the other side.
void pad(Panorama& panorama) {
    const std::size_t width = panorama.width;
    Lanes* first = panorama.pixels.get();
    Lanes* last = first + (panorama.height + 1) * panorama.stride;
    for (std::size_t x = 0; x < width; ++x) {
        const std::size_t opposite = (x + width / 2) % width;
        first[x] = first[panorama.stride + opposite];
        last[x] = (last - panorama.stride)[opposite];
    }
    for (std::size_t y = 0; y < panorama.height + 2U; ++y) {
        Lanes* row = first + y * panorama.stride;
        row[width] = row[0];
        row[width + 1] = row[1 % width];
    }
}

}  // namespace

Panorama make_panorama(const image::Image& latlong, float intensity, base::ThreadPool& pool) {
    Panorama out{.width = latlong.size.width,
                 .height = latlong.size.height,
                 .stride = std::size_t{latlong.size.width} + 2,
                 .pixels = nullptr};
    // Not zeroed: the rows are first touched by the threads that fill them.
    out.pixels.reset(new Lanes[out.stride * (std::size_t{out.height} + 2)]);
    const auto source = latlong.as<float>();
    pool.parallel_for(out.height, [&](std::size_t y) {
        Lanes* row = out.pixels.get() + (y + 1) * out.stride;
        read_row(source.subspan(y * out.width * 3, std::size_t{out.width} * 3), intensity, row);
        const double sine =
            std::sin((static_cast<double>(y) + 0.5) / out.height * 3.14159265358979323846);
        const double columns = std::min(out.width / (2.0 * out.height * sine), 1.0 * out.width);
        constexpr double negligible_columns = 2.0;  // less than the bilinear filter's own width
        if (columns > negligible_columns) blur_row(row, out.width, columns);
    });
    pad(out);
    return out;
}

}  // namespace facet::frame
