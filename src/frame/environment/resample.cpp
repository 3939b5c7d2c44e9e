// From a lat-long picture to rows of a cube map's faces.
// SPDX-License-Identifier: MIT
#include "frame/environment/resample.h"

#include "frame/environment/cube_mip.h"
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
    column_of_zero_ = static_cast<float>(zero - std::floor(zero / width) * width);
    const std::uint32_t count = face_px * taps_;
    for (std::uint32_t j = 0; j < count; ++j) {
        s_.push_back(texel_center(j, count));
        side_cosine_.push_back(1.0F / std::sqrt(1.0F + s_[j] * s_[j]));
    }
    // phi = middle - atan(s) on all four, with the middles of +x -x +z -z at these parts of a turn.
    constexpr std::array<float, 4> middle_turns = {0.25F, -0.25F, 0.5F, 0.0F};
    std::vector<float> x(count);
    for (std::size_t face = 0; face < 4; ++face) {
        const float middle = middle_turns[face] * static_cast<float>(panorama.width);
        for (std::size_t j = 0; j < count; ++j)
            x[j] = middle - arctangent(s_[j]) * columns_per_radian_;
        side_columns_[face] = columns_of(x);
    }
}

/// `x`: columns from phi = 0, less than a turn away.
CubeResampler::Taps CubeResampler::columns_of(const std::vector<float>& x) const {
    Taps out{std::vector<std::int32_t>(x.size()), std::vector<float>(x.size())};
    const auto width = static_cast<float>(panorama_.width);
    for (std::size_t j = 0; j < x.size(); ++j) {
        const float turned = column_of_zero_ + x[j];
        const float above = turned < 0.0F ? turned + width : turned;
        const float column = above >= width ? above - width : above;
        out.index[j] = static_cast<std::int32_t>(column);
        out.fraction[j] = column - static_cast<float>(out.index[j]);
    }
    return out;
}

/// `y`: rows of the padded picture, [0.5, height + 0.5].
CubeResampler::Taps CubeResampler::rows_of(const std::vector<float>& y) {
    Taps out{std::vector<std::int32_t>(y.size()), std::vector<float>(y.size())};
    for (std::size_t j = 0; j < y.size(); ++j) {
        out.index[j] = static_cast<std::int32_t>(y[j]);
        out.fraction[j] = y[j] - static_cast<float>(out.index[j]);
    }
    return out;
}

void CubeResampler::add_row(const Taps& columns, const Taps& rows, Lanes* out) const {
    const Lanes share = lanes_of(1.0F / static_cast<float>(taps_ * taps_));
    const auto stride = static_cast<std::ptrdiff_t>(panorama_.stride);
    const Lanes* const pixels = panorama_.pixels.get();
    for (std::uint32_t texel = 0; texel < face_px_; ++texel) {
        Lanes sum{};
        for (std::size_t j = texel * taps_; j < (texel + 1) * taps_; ++j) {
            const Lanes* top = pixels + rows.index[j] * stride + columns.index[j];
            const Lanes* bottom = top + stride;
            const Lanes a = top[0] + (top[1] - top[0]) * columns.fraction[j];
            const Lanes b = bottom[0] + (bottom[1] - bottom[0]) * columns.fraction[j];
            sum += a + (b - a) * rows.fraction[j];
        }
        out[texel] += sum * share;
    }
}

void CubeResampler::side_rows(std::uint32_t row, Lanes* out) const {
    const float middle_row = 0.5F * static_cast<float>(panorama_.height) + 0.5F;
    std::vector<float> y(s_.size());
    std::fill_n(out, std::size_t{4} * face_px_, Lanes{});
    for (std::uint32_t tap_row = row * taps_; tap_row < (row + 1) * taps_; ++tap_row) {
        const float t = s_[tap_row];
        for (std::size_t j = 0; j < y.size(); ++j)
            y[j] = middle_row + arctangent(t * side_cosine_[j]) * rows_per_radian_;
        const Taps rows = rows_of(y);
        for (std::size_t face = 0; face < 4; ++face)
            add_row(side_columns_[face], rows, out + face * face_px_);
    }
}

void CubeResampler::pole_rows(std::uint32_t row, Lanes* out) const {
    const float height = static_cast<float>(panorama_.height);
    const float half_turn = 0.5F * static_cast<float>(panorama_.width);
    const std::size_t count = s_.size();
    std::vector<float> x(count);
    std::vector<float> y(count);
    std::fill_n(out, std::size_t{2} * face_px_, Lanes{});
    for (std::uint32_t tap_row = row * taps_; tap_row < (row + 1) * taps_; ++tap_row) {
        const float t = s_[tap_row];
        const float b = std::fabs(t);
        for (std::size_t j = 0; j < count; ++j) {
            const float a = std::fabs(s_[j]);
            const float angle = arctangent(std::min(a, b) / std::max(a, b));
            const float from_t = a > b ? 0.5F * math::pi - angle : angle;
            const float phi = t > 0.0F ? math::pi - from_t : from_t;  // atan2(|s|, -t)
            x[j] = std::copysign(phi, s_[j]) * columns_per_radian_;
            const float radius = std::sqrt(a * a + b * b);
            const float inner = arctangent(std::min(radius, 1.0F / radius));
            y[j] = (radius > 1.0F ? 0.5F * math::pi - inner : inner) * rows_per_radian_ + 0.5F;
        }
        add_row(columns_of(x), rows_of(y), out);
        // Face -y at the same (s, t) looks to pi - phi, as far from its own pole.
        for (std::size_t j = 0; j < count; ++j) {
            x[j] = std::copysign(half_turn, s_[j]) - x[j];
            y[j] = height + 1.0F - y[j];
        }
        add_row(columns_of(x), rows_of(y), out + face_px_);
    }
}

}  // namespace facet::frame
