// The environment blurred by Gaussians in octaves.
// SPDX-License-Identifier: MIT
#include "frame/environment/gaussian_pyramid.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace facet::frame {
namespace {

// Four by four taps at +-1/2 and +-3/2 of their spacing. Between bilinear taps on a Gaussian of
// width sigma nothing is lost while the spacing is below 2 sigma: the first alias is exp(-2 pi^2
// (sigma / spacing)^2).
constexpr float spacing_in_sigmas = 1.9F;
// The step from sigma to 2 sigma adds a variance of 3 sigma^2; in units of the spacing squared:
constexpr float tap_variance = 3.0F / (spacing_in_sigmas * spacing_in_sigmas);
// Two weights a side, inner + outer = 1/2, that have this variance: 2 (inner / 4 + outer 9 / 4).
constexpr float outer_weight = (tap_variance - 0.25F) / 4.0F;
constexpr float inner_weight = 0.5F - outer_weight;

constexpr float tent_variance = 1.0F / 6.0F;  // of bilinear filtering, in texels squared
constexpr float box_variance = 1.0F / 12.0F;  // of a texel
constexpr float binomial_variance = 0.5F;     // of the weights 1 2 1

/// Four taps a quarter turn apart, which leaves any linear gradient as it is.
struct TapGroup {
    float x, y;  ///< of the first, in spacings
    float weight;
};
constexpr std::array<TapGroup, 4> taps = {{{0.5F, 0.5F, inner_weight* inner_weight},
                                           {1.5F, 0.5F, inner_weight* outer_weight},
                                           {0.5F, 1.5F, inner_weight* outer_weight},
                                           {1.5F, 1.5F, outer_weight* outer_weight}}};

/// A variance that is `even` everywhere less `texel` times a texel's relative solid angle, in
/// rad^2: what has to be added to filters on the texel grid, whose width follows the texels', to be
/// of one width everywhere.
struct Variance {
    float even = 0.0F;
    float texel = 0.0F;
};

/// tan(x) / x; narrow filters take three terms of the series, which are as good as the function
/// there.
float tangent_over(float x) {
    constexpr float series_end = 0.1F;  // the next term is 17 x^6 / 315: 5e-8
    const float x2 = x * x;
    return x < series_end ? 1.0F + x2 * (1.0F / 3.0F + x2 * (2.0F / 15.0F)) : std::tan(x) / x;
}

Lanes tapped(const CubeMip& source, const TexelFrame& frame, float spacing_rad) {
    Lanes sum{};
    for (const TapGroup& group : taps) {
        const float radius = std::sqrt(group.x * group.x + group.y * group.y);
        const float scale = spacing_rad * tangent_over(radius * spacing_rad);
        const float x = group.x * scale;
        const float y = group.y * scale;
        const FourDirections d = frame.n * lanes_of(1.0F) + frame.t * Lanes{x, -y, -x, y} +
                                 frame.b * Lanes{y, x, -y, -x};
        const auto four = source.sample(d);
        sum += (four[0] + four[1] + four[2] + four[3]) * group.weight;
    }
    return sum;
}

CubeMip blurred(const CubeMip& source, std::uint32_t side, const Variance& added,
                base::ThreadPool& pool) {
    CubeMip out = make_mip(side);
    pool.parallel_for(std::size_t{6} * side, [&](std::size_t task) {
        const auto face = static_cast<std::uint32_t>(task / side);
        const std::size_t row = task % side;
        for (std::size_t column = 0; column < side; ++column) {
            const TexelFrame frame = texel_frame(face, row, column, side);
            const float variance = std::max(added.even - added.texel * frame.solid_angle, 0.0F);
            out.at(face, row, column) = tapped(source, frame, std::sqrt(variance / tap_variance));
        }
    });
    fill_borders(out);
    return out;
}

/// Weights 1 2 1 in rows and columns.
CubeMip binomial(const CubeMip& source, base::ThreadPool& pool) {
    CubeMip out = make_mip(source.side);
    const std::size_t stride = source.stride();
    pool.parallel_for(std::size_t{6} * source.side, [&](std::size_t task) {
        const auto face = static_cast<std::uint32_t>(task / source.side);
        const std::size_t row = task % source.side;
        const Lanes* middle = &source.at(face, row, 0);
        Lanes* target = &out.at(face, row, 0);
        const auto column_sum = [&](const Lanes* p) {
            return *(p - stride) + *p + *p + *(p + stride);
        };
        for (std::size_t x = 0; x < source.side; ++x) {
            const Lanes* p = middle + x;
            const Lanes center = column_sum(p);
            target[x] =
                (column_sum(p - 1) + center + center + column_sum(p + 1)) * lanes_of(1.0F / 16.0F);
        }
    });
    fill_borders(out);
    return out;
}

float middle_texel_rad(std::uint32_t side) { return 2.0F / static_cast<float>(side); }

}  // namespace

std::vector<Blurred> make_gaussian_pyramid(const CubePyramid& pyramid, float finest_rad,
                                           float widest_rad, base::ThreadPool& pool) {
    constexpr float texel_in_sigmas = 0.8F;
    std::size_t mip = 0;  // the coarsest whose texels are small enough
    while (mip + 1 < pyramid.mips.size() &&
           middle_texel_rad(pyramid.mips[mip + 1].side) <= texel_in_sigmas * finest_rad)
        ++mip;
    const CubeMip& source = pyramid.mips[mip];
    const float texel = middle_texel_rad(source.side);
    float sigma = std::max(finest_rad, texel / texel_in_sigmas);

    std::vector<Blurred> out;
    // Bilinear filtering counts twice: for the taps, and for whoever samples the result.
    const float before = (box_variance + binomial_variance + 2.0F * tent_variance) * texel * texel;
    out.push_back(
        {blurred(binomial(source, pool), source.side, {sigma * sigma, before}, pool), sigma});
    while (2.0F * sigma < widest_rad && out.back().map.side > pyramid.mips.back().side) {
        const CubeMip& finer = out.back().map;
        const float step = middle_texel_rad(finer.side / 2);
        CubeMip next = blurred(finer, finer.side / 2,
                               {3.0F * sigma * sigma, tent_variance * step * step}, pool);
        sigma *= 2.0F;
        out.push_back({std::move(next), sigma});
    }
    return out;
}

}  // namespace facet::frame
