// The environment as the tracer sees it.
// SPDX-License-Identifier: MIT
#include "trace/environment_light.h"

#include "math/color.h"

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Vec2;
using math::Vec3;
using math::Vec4;

/// Above every light there is; keeps products with it finite in float.
constexpr float radiance_max_nit = 1e30F;

}  // namespace

Distribution::Distribution(std::size_t width, std::size_t rows)
    : width_(width), cumulative_((width + 1) * rows), guide_(width * rows) {}

double Distribution::set_row(std::size_t row, std::span<const float> weights) {
    float* cumulative = cumulative_.data() + row * (width_ + 1);
    double total = 0.0;
    for (const float weight : weights) total += static_cast<double>(weight);
    double sum = 0.0;
    for (std::size_t i = 0; i < width_; ++i) {
        sum += static_cast<double>(weights[i]);
        const double share =
            total > 0.0 ? sum / total : static_cast<double>(i + 1) / static_cast<double>(width_);
        cumulative[i + 1] = static_cast<float>(std::min(1.0, share));
    }
    cumulative[width_] = 1.0F;
    std::uint32_t* guide = guide_.data() + row * width_;
    std::uint32_t cell = 0;
    for (std::size_t i = 0; i < width_; ++i) {
        const float u = static_cast<float>(i) / static_cast<float>(width_);
        while (cell + 1 < width_ && cumulative[cell + 1] <= u) ++cell;
        guide[i] = cell;
    }
    return total;
}

Distribution::Draw Distribution::draw(float u, std::size_t row) const {
    const float* cumulative = cumulative_.data() + row * (width_ + 1);
    const auto first =
        std::min(static_cast<std::size_t>(u * static_cast<float>(width_)), width_ - 1);
    std::uint32_t cell = guide_[row * width_ + first];
    while (cell + 1 < width_ && cumulative[cell + 1] <= u) ++cell;
    const float share = cumulative[cell + 1] - cumulative[cell];
    const float within = share > 0.0F ? (u - cumulative[cell]) / share : 0.5F;
    return {cell, share, std::clamp(within, 0.0F, 0.99999994F)};
}

EnvironmentLight::EnvironmentLight(const image::Image& latlong, float rotation_deg, float intensity,
                                   base::ThreadPool& pool)
    : width_(static_cast<int>(latlong.size.width)),
      height_(static_cast<int>(latlong.size.height)),
      rotation_rad_(glm::radians(rotation_deg)),
      cell_sr_(2.0F * math::pi / static_cast<float>(width_) * math::pi /
               static_cast<float>(height_)),
      texels_(static_cast<std::size_t>(latlong.size.pixels())),
      columns_(latlong.size.width, latlong.size.height) {
    const std::size_t width = latlong.size.width;
    const std::size_t height = latlong.size.height;
    const auto pixels = latlong.as<float>();
    pool.parallel_for(height, [&](std::size_t y) {
        for (std::size_t i = y * width; i < (y + 1) * width; ++i)
            for (int c = 0; c < 3; ++c)
                texels_[i][c] = std::min(pixels[i * 3 + static_cast<std::size_t>(c)] * intensity,
                                         radiance_max_nit);
    });
    const auto luminance = [&](std::size_t x, std::size_t y) {
        return math::luminance(Vec3(texels_[y * width + x]));
    };
    std::vector<float> sums(height);
    pool.parallel_for(height, [&](std::size_t y) {
        // What is seen of a pixel's cell is bilinear: its mean takes an eighth of each neighbour.
        const std::size_t above = y == 0 ? 0 : y - 1;
        const std::size_t below = std::min(y + 1, height - 1);
        std::vector<float> column(width);
        for (std::size_t x = 0; x < width; ++x)
            column[x] =
                0.75F * luminance(x, y) + 0.125F * (luminance(x, above) + luminance(x, below));
        std::vector<float> weights(width);
        for (std::size_t x = 0; x < width; ++x)
            weights[x] = 0.75F * column[x] +
                         0.125F * (column[(x + width - 1) % width] + column[(x + 1) % width]);
        const double step = 3.14159265358979323846 / static_cast<double>(height);
        const double share =
            std::cos(static_cast<double>(y) * step) - std::cos(static_cast<double>(y + 1) * step);
        sums[y] = static_cast<float>(columns_.set_row(y, weights) * share);
    });
    rows_ = Distribution(std::span<const float>(sums));
    is_black_ = std::all_of(sums.begin(), sums.end(), [](float sum) { return sum <= 0.0F; });
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            texels_[y * width + x].w = rows_.share(y) * columns_.share(x, y);
}

Vec3 EnvironmentLight::radiance(Vec2 at_px) const {
    const float left = std::floor(at_px.x - 0.5F);
    const float top = std::floor(at_px.y - 0.5F);
    const float across = at_px.x - 0.5F - left;
    const float down = at_px.y - 0.5F - top;
    const auto column = [&](int x) { return x < 0 ? x + width_ : x >= width_ ? x - width_ : x; };
    const int x0 = column(static_cast<int>(left));
    const int x1 = column(static_cast<int>(left) + 1);
    const Vec4* upper = texels_.data() + std::clamp(static_cast<int>(top), 0, height_ - 1) * width_;
    const Vec4* lower =
        texels_.data() + std::clamp(static_cast<int>(top) + 1, 0, height_ - 1) * width_;
    return Vec3((upper[x0] * (1.0F - across) + upper[x1] * across) * (1.0F - down) +
                (lower[x0] * (1.0F - across) + lower[x1] * across) * down);
}

Vec3 EnvironmentLight::irradiance_from_above() const {
    glm::dvec3 sum(0.0);
    const double step = 3.14159265358979323846 / height_;
    for (int y = 0; 2 * y < height_; ++y) {
        // Cosine and solid angle over the row, exactly: half the difference of squared sines.
        const double low = std::sin(y * step);
        const double high = std::sin(std::min((y + 1) * step, 0.5 * 3.14159265358979323846));
        glm::dvec3 row(0.0);
        for (int x = 0; x < width_; ++x)
            row += glm::dvec3(texels_[static_cast<std::size_t>(y * width_ + x)]);
        sum += row * ((high * high - low * low) / width_);
    }
    return Vec3(sum);
}

EnvironmentLight::Light EnvironmentLight::at(const Vec3& d) const {
    // The middle column is -z and columns to its right turn towards +x; the environment turns
    // counter-clockwise seen from above (contract, "Conventions").
    const float turn = (std::atan2(d.x, -d.z) + rotation_rad_) / (2.0F * math::pi) + 0.5F;
    const float polar = std::acos(std::clamp(d.y, -1.0F, 1.0F)) / math::pi;
    const Vec2 at_px((turn - std::floor(turn)) * static_cast<float>(width_),
                     polar * static_cast<float>(height_));
    const int x = std::clamp(static_cast<int>(at_px.x), 0, width_ - 1);
    const int y = std::clamp(static_cast<int>(at_px.y), 0, height_ - 1);
    const float sine = std::sqrt(std::max(1.0F - d.y * d.y, 1e-12F));
    return {radiance(at_px),
            texels_[static_cast<std::size_t>(y * width_ + x)].w / (cell_sr_ * sine)};
}

EnvironmentLight::Sample EnvironmentLight::sample(Vec2 u) const {
    const auto row = rows_.draw(u.y);
    const auto column = columns_.draw(u.x, row.cell);
    const Vec2 at_px(static_cast<float>(column.cell) + column.within,
                     static_cast<float>(row.cell) + row.within);
    const float polar = at_px.y / static_cast<float>(height_) * math::pi;
    const float azimuth =
        (at_px.x / static_cast<float>(width_) - 0.5F) * 2.0F * math::pi - rotation_rad_;
    const float sine = std::sin(polar);
    Sample out;
    if (sine <= 0.0F) return out;
    out.direction = {sine * std::sin(azimuth), std::cos(polar), -sine * std::cos(azimuth)};
    out.light = {radiance(at_px), row.share * column.share / (cell_sr_ * sine)};
    return out;
}

}  // namespace facet::trace
