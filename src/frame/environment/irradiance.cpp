// Diffuse light of an environment by direction.
// SPDX-License-Identifier: MIT
#include "frame/environment/irradiance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace facet::frame {
namespace {

using math::Vec3;
using std::numbers::pi;
/// Cells from pole to pole at most; twice as many around.
constexpr std::uint32_t most_rows = 64;

struct Cell {
    Vec3 direction{0.0F};
    float solid_angle = 0.0F;
    Lanes light{};  ///< radiance times solid angle
};

/// A picture's pixels, each cut into `parts` x `parts`: a cosine turns within one of a small
/// picture's.
struct Pixels {
    const Panorama& panorama;
    std::uint32_t parts;
    std::uint32_t width = panorama.width * parts;
    std::uint32_t height = panorama.height * parts;
    std::vector<double> sin_phi{}, cos_phi{};  ///< of each column, turned
    [[nodiscard]] const Lanes& at(std::uint32_t x, std::uint32_t y) const {
        return panorama.pixels[(std::size_t{y / parts} + 1) * panorama.stride + x / parts];
    }
};

/// Pixels [x0, x1) x [y0, y1) as one.
Cell cell_of(const Pixels& pixels, std::uint32_t x0, std::uint32_t x1, std::uint32_t y0,
             std::uint32_t y1) {
    double solid_angle = 0.0;
    double light[3] = {};
    double middle[3] = {};  // of the cell
    double bright[3] = {};  // of its light
    for (std::uint32_t y = y0; y < y1; ++y) {
        const double top = pi * y / pixels.height;
        const double bottom = pi * (y + 1.0) / pixels.height;
        const double omega = 2.0 * pi / pixels.width * (std::cos(top) - std::cos(bottom));
        const double sin_polar = std::sin(0.5 * (top + bottom));
        const double cos_polar = std::cos(0.5 * (top + bottom));
        for (std::uint32_t x = x0; x < x1; ++x) {
            const Lanes& pixel = pixels.at(x, y);
            const double d[3] = {pixels.sin_phi[x] * sin_polar, cos_polar,
                                 -pixels.cos_phi[x] * sin_polar};
            double sum = 0.0;
            for (int c = 0; c < 3; ++c) {
                const double part = static_cast<double>(pixel[c]) * omega;
                light[c] += part;
                sum += part;
            }
            for (int c = 0; c < 3; ++c) {
                middle[c] += d[c] * omega;
                bright[c] += d[c] * sum;
            }
            solid_angle += omega;
        }
    }
    const bool is_dark = light[0] + light[1] + light[2] <= 0.0;
    const double* way = is_dark ? middle : bright;
    Cell out;
    out.direction = Vec3(math::normalize(math::DVec3(way[0], way[1], way[2])));
    out.solid_angle = static_cast<float>(solid_angle);
    out.light = Lanes{static_cast<float>(light[0]), static_cast<float>(light[1]),
                      static_cast<float>(light[2]), 0.0F};
    return out;
}

std::vector<Cell> cells_of(const Panorama& panorama, double rotation_rad, base::ThreadPool& pool) {
    const std::uint32_t least = std::min(panorama.height, panorama.width);
    Pixels pixels{panorama, (most_rows + least - 1) / least};
    for (std::uint32_t x = 0; x < pixels.width; ++x) {
        const double phi = ((x + 0.5) / pixels.width - 0.5) * 2.0 * pi - rotation_rad;
        pixels.sin_phi.push_back(std::sin(phi));
        pixels.cos_phi.push_back(std::cos(phi));
    }
    const std::uint32_t down = std::min(pixels.height, most_rows);
    const std::uint32_t across = std::min(pixels.width, 2 * most_rows);
    std::vector<Cell> cells(std::size_t{down} * across);
    const auto part = [](std::uint32_t i, std::uint32_t count, std::uint32_t whole) {
        return static_cast<std::uint32_t>(std::uint64_t{i} * whole / count);
    };
    pool.parallel_for(down, [&](std::size_t row) {
        const auto j = static_cast<std::uint32_t>(row);
        for (std::uint32_t i = 0; i < across; ++i)
            cells[row * across + i] =
                cell_of(pixels, part(i, across, pixels.width), part(i + 1, across, pixels.width),
                        part(j, down, pixels.height), part(j + 1, down, pixels.height));
    });
    return cells;
}

}  // namespace

CubeMip irradiance_over_pi(const Panorama& panorama, float rotation_deg, std::uint32_t side,
                           base::ThreadPool& pool) {
    const std::vector<Cell> cells =
        cells_of(panorama, static_cast<double>(rotation_deg) * pi / 180.0, pool);
    CubeMip out = make_mip(side);
    pool.parallel_for(std::size_t{6} * side, [&](std::size_t task) {
        const auto face = static_cast<std::uint32_t>(task / side);
        const std::size_t row = task % side;
        for (std::size_t column = 0; column < side; ++column) {
            const Vec3 n = texel_frame(face, row, column, side).n;
            Lanes sum{};
            float weights = 0.0F;
            for (const Cell& cell : cells) {
                const float cosine = std::max(0.0F, math::dot(n, cell.direction));
                sum += cell.light * cosine;
                weights += cosine * cell.solid_angle;
            }
            // The cells' own sum stands for pi: an even light stays what it is.
            constexpr float exact = math::pi;
            const float even = std::fabs(weights / exact - 1.0F) < 0.01F ? weights : exact;
            out.at(face, row, column) = sum * (1.0F / even);
        }
    });
    fill_borders(out);
    return out;
}

}  // namespace facet::frame
