// From a lat-long picture to rows of a cube map's faces.
// SPDX-License-Identifier: MIT
#include "frame/environment/resample.h"

#include "math/vector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facet::frame {
namespace {

/// atan(x) for |x| <= 1, error below 2e-8: a polynomial vectorises where the library's function
/// does not. Source: Abramowitz & Stegun 1964, 4.4.49.
float arctangent(float x) noexcept {
    const float z = x * x;
    float p = 0.0028662257F;
    p = p * z - 0.0161657367F;
    p = p * z + 0.0429096138F;
    p = p * z - 0.0752896400F;
    p = p * z + 0.1065626393F;
    p = p * z - 0.1420889944F;
    p = p * z + 0.1999355085F;
    p = p * z - 0.3333314528F;
    return x + x * z * p;
}

/// How many taps a side keep two neighbours closer than a source pixel, at a face's middle where
/// texels are largest: 2 / face_px radians.
std::uint32_t taps_for(const Panorama& panorama, std::uint32_t face_px) {
    const float pixels_per_radian =
        std::max(static_cast<float>(panorama.height) / math::pi,
                 static_cast<float>(panorama.width) / (2.0F * math::pi));
    const float pixels = pixels_per_radian * 2.0F / static_cast<float>(face_px);
    return static_cast<std::uint32_t>(std::clamp(std::ceil(1.5F * pixels), 2.0F, 16.0F));
}

}  // namespace

CubeResampler::CubeResampler(const Panorama& panorama, std::uint32_t face_px, float rotation_deg)
    : panorama_(panorama),
      face_px_(face_px),
      taps_(taps_for(panorama, face_px)),
      columns_per_radian_(static_cast<float>(panorama.width) / (2.0F * math::pi)),
      rows_per_radian_(static_cast<float>(panorama.height) / math::pi) {
    const double width = panorama.width;
    const double zero = (0.5 + static_cast<double>(rotation_deg) / 360.0) * width - 0.5;
    x_of_zero_ = static_cast<float>(zero - std::floor(zero / width) * width);
    const std::uint32_t count = face_px * taps_;
    for (std::uint32_t j = 0; j < count; ++j) {
        const float s = (static_cast<float>(j) + 0.5F) / static_cast<float>(count) * 2.0F - 1.0F;
        s_.push_back(s);
        side_columns_.push_back(arctangent(s) * columns_per_radian_);
        side_cosine_.push_back(1.0F / std::sqrt(1.0F + s * s));
    }
}

/// One turn at most beyond either end.
float CubeResampler::wrapped(float x) const noexcept {
    const auto width = static_cast<float>(panorama_.width);
    x = x < 0.0F ? x + width : x;
    return x >= width ? x - width : x;
}

void CubeResampler::side_rows(std::uint32_t row, Lanes* out) const {
    // phi = middle - atan(s) on all four, with the middles of +x -x +z -z at these parts of a turn.
    constexpr std::array<float, 4> middle_turns = {0.25F, 0.75F, 0.5F, 0.0F};
    const float middle_row = 0.5F * static_cast<float>(panorama_.height) + 0.5F;
    const Lanes share = lanes_of(1.0F / static_cast<float>(taps_ * taps_));
    std::vector<float> y(s_.size());
    std::fill_n(out, std::size_t{4} * face_px_, Lanes{});
    for (std::uint32_t tap_row = row * taps_; tap_row < (row + 1) * taps_; ++tap_row) {
        const float t = s_[tap_row];
        for (std::size_t j = 0; j < y.size(); ++j)
            y[j] = middle_row + arctangent(t * side_cosine_[j]) * rows_per_radian_;
        for (std::size_t face = 0; face < 4; ++face) {
            const float middle =
                wrapped(x_of_zero_ + middle_turns[face] * static_cast<float>(panorama_.width));
            for (std::uint32_t texel = 0; texel < face_px_; ++texel) {
                Lanes sum{};
                for (std::size_t j = texel * taps_; j < (texel + 1) * taps_; ++j)
                    sum += panorama_.sample(wrapped(middle - side_columns_[j]), y[j]);
                out[face * face_px_ + texel] += sum * share;
            }
        }
    }
}

void CubeResampler::pole_rows(std::uint32_t row, Lanes* out) const {
    const auto height = static_cast<float>(panorama_.height);
    const float half_turn = 0.5F * static_cast<float>(panorama_.width);
    const Lanes share = lanes_of(1.0F / static_cast<float>(taps_ * taps_));
    std::vector<float> x(s_.size());
    std::vector<float> y(s_.size());
    std::fill_n(out, std::size_t{2} * face_px_, Lanes{});
    for (std::uint32_t tap_row = row * taps_; tap_row < (row + 1) * taps_; ++tap_row) {
        const float t = s_[tap_row];
        for (std::size_t j = 0; j < s_.size(); ++j) {
            const float a = std::fabs(s_[j]);
            const float b = std::fabs(t);
            const float angle = arctangent(std::min(a, b) / std::max(a, b));
            const float from_t = a > b ? 0.5F * math::pi - angle : angle;
            const float phi = t > 0.0F ? math::pi - from_t : from_t;  // atan2(|s|, -t)
            x[j] = std::copysign(phi, s_[j]) * columns_per_radian_;
            const float radius = std::sqrt(a * a + b * b);
            const float inner = arctangent(std::min(radius, 1.0F / radius));
            y[j] = (radius > 1.0F ? 0.5F * math::pi - inner : inner) * rows_per_radian_;
        }
        for (std::uint32_t texel = 0; texel < face_px_; ++texel) {
            Lanes up{};
            Lanes down{};
            for (std::size_t j = texel * taps_; j < (texel + 1) * taps_; ++j) {
                up += panorama_.sample(wrapped(x_of_zero_ + x[j]), y[j] + 0.5F);
                // Face -y at the same (s, t) looks to phi' = pi - phi, as far from its own pole.
                const float mirrored = x[j] > 0.0F ? half_turn - x[j] : -half_turn - x[j];
                down += panorama_.sample(wrapped(x_of_zero_ + mirrored), height + 0.5F - y[j]);
            }
            out[texel] += up * share;
            out[face_px_ + texel] += down * share;
        }
    }
}

}  // namespace facet::frame
