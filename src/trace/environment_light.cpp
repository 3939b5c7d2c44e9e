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

/// Above every light there is; keeps products with it finite in float.
constexpr float radiance_max_nit = 1e30F;

}  // namespace

Distribution::Distribution(std::vector<float> weights) {
    const std::size_t count = weights.size();
    for (const float weight : weights) total_ += static_cast<double>(weight);
    cumulative_.resize(count + 1);
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        sum += static_cast<double>(weights[i]);
        cumulative_[i + 1] = total_ > 0.0 ? static_cast<float>(std::min(1.0, sum / total_))
                                          : static_cast<float>(i + 1) / static_cast<float>(count);
    }
    cumulative_[count] = 1.0F;
    guide_.resize(count);
    std::uint32_t cell = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const float u = static_cast<float>(i) / static_cast<float>(count);
        while (cell + 1 < count && cumulative_[cell + 1] <= u) ++cell;
        guide_[i] = cell;
    }
}

Distribution::Draw Distribution::draw(float u) const {
    const auto count = static_cast<std::uint32_t>(guide_.size());
    const auto first =
        std::min(static_cast<std::uint32_t>(u * static_cast<float>(count)), count - 1);
    std::uint32_t cell = guide_[first];
    while (cell + 1 < count && cumulative_[cell + 1] <= u) ++cell;
    const float share = cumulative_[cell + 1] - cumulative_[cell];
    const float within = share > 0.0F ? (u - cumulative_[cell]) / share : 0.5F;
    return {cell, share, std::clamp(within, 0.0F, 0.99999994F)};
}

EnvironmentLight::EnvironmentLight(const image::Image& latlong, float rotation_deg, float intensity,
                                   base::ThreadPool& pool)
    : latlong_(&latlong), intensity_(intensity), rotation_rad_(glm::radians(rotation_deg)) {
    const std::size_t width = latlong.size.width;
    const std::size_t height = latlong.size.height;
    const auto pixels = latlong.as<float>();
    const auto luminance = [&](std::size_t x, std::size_t y) {
        const float* p = pixels.data() + (y * width + x) * 3;
        return std::min(math::luminance({p[0], p[1], p[2]}), radiance_max_nit);
    };
    columns_.resize(height);
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
        columns_[y] = Distribution(std::move(weights));
        const auto at = static_cast<double>(y);
        const double solid_angle =
            std::cos(at / static_cast<double>(height) * 3.14159265358979323846) -
            std::cos((at + 1.0) / static_cast<double>(height) * 3.14159265358979323846);
        sums[y] =
            static_cast<float>(columns_[y].total() * solid_angle * static_cast<double>(intensity));
    });
    rows_ = Distribution(std::move(sums));
}

Vec2 EnvironmentLight::pixel_of(const Vec3& d) const {
    const float width = static_cast<float>(latlong_->size.width);
    const float height = static_cast<float>(latlong_->size.height);
    // The middle column is -z and columns to its right turn towards +x; the environment turns
    // counter-clockwise seen from above (contract, "Conventions").
    const float turn = (std::atan2(d.x, -d.z) + rotation_rad_) / (2.0F * math::pi) + 0.5F;
    const float polar = std::acos(std::clamp(d.y, -1.0F, 1.0F)) / math::pi;
    return {(turn - std::floor(turn)) * width, polar * height};
}

Vec3 EnvironmentLight::radiance(const Vec3& direction) const {
    const auto width = static_cast<int>(latlong_->size.width);
    const auto height = static_cast<int>(latlong_->size.height);
    const Vec2 at = pixel_of(direction) - 0.5F;
    const float left = std::floor(at.x);
    const float top = std::floor(at.y);
    const float across = at.x - left;
    const float down = at.y - top;
    const auto column = [&](int x) { return x < 0 ? x + width : x >= width ? x - width : x; };
    const int x0 = column(static_cast<int>(left));
    const int x1 = column(static_cast<int>(left) + 1);
    const int y0 = std::clamp(static_cast<int>(top), 0, height - 1);
    const int y1 = std::clamp(static_cast<int>(top) + 1, 0, height - 1);
    const float* pixels = latlong_->as<float>().data();
    const auto nit = [&](int x, int y) {
        const float* p = pixels + (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                   static_cast<std::size_t>(x)) *
                                      3;
        return Vec3(p[0], p[1], p[2]);
    };
    const Vec3 upper = nit(x0, y0) * (1.0F - across) + nit(x1, y0) * across;
    const Vec3 lower = nit(x0, y1) * (1.0F - across) + nit(x1, y1) * across;
    return glm::min((upper * (1.0F - down) + lower * down) * intensity_, Vec3(radiance_max_nit));
}

EnvironmentLight::Sample EnvironmentLight::sample(Vec2 u) const {
    const auto row = rows_.draw(u.y);
    const auto column = columns_[row.cell].draw(u.x);
    const auto width = static_cast<float>(latlong_->size.width);
    const auto height = static_cast<float>(latlong_->size.height);
    const float polar = (static_cast<float>(row.cell) + row.within) / height * math::pi;
    const float azimuth =
        ((static_cast<float>(column.cell) + column.within) / width - 0.5F) * 2.0F * math::pi -
        rotation_rad_;
    const float sine = std::sin(polar);
    const float solid_angle = 2.0F * math::pi / width * math::pi / height * sine;
    if (solid_angle <= 0.0F) return {};
    return {{sine * std::sin(azimuth), std::cos(polar), -sine * std::cos(azimuth)},
            row.share * column.share / solid_angle};
}

float EnvironmentLight::pdf(const Vec3& direction) const {
    const Vec2 at = pixel_of(direction);
    const std::uint32_t width = latlong_->size.width;
    const std::uint32_t height = latlong_->size.height;
    const std::uint32_t x = std::min(static_cast<std::uint32_t>(at.x), width - 1);
    const std::uint32_t y = std::min(static_cast<std::uint32_t>(at.y), height - 1);
    const float sine = std::sqrt(std::max(1.0F - direction.y * direction.y, 0.0F));
    const float solid_angle =
        2.0F * math::pi / static_cast<float>(width) * math::pi / static_cast<float>(height) * sine;
    return solid_angle > 0.0F ? rows_.share(y) * columns_[y].share(x) / solid_angle : 0.0F;
}

}  // namespace facet::trace
