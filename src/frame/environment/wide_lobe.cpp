// The environment through a wide lobe.
// SPDX-License-Identifier: MIT
#include "frame/environment/wide_lobe.h"

#include <algorithm>
#include <vector>

namespace facet::frame {
namespace {

constexpr std::uint32_t source_px = 16;

/// Four texels: where they are, how much of the sphere they cover, and their radiance times that.
struct FourTexels {
    Lanes x, y, z;
    Lanes solid_angle;
    Lanes red, green, blue;
};

std::vector<FourTexels> sources_of(const CubeMip& mip) {
    std::vector<FourTexels> out(std::size_t{6} * mip.side * mip.side / 4);
    std::size_t i = 0;
    for (std::uint32_t face = 0; face < 6; ++face)
        for (std::size_t row = 0; row < mip.side; ++row)
            for (std::size_t column = 0; column < mip.side; ++column, ++i) {
                const TexelFrame frame = texel_frame(face, row, column, mip.side);
                const Lanes& radiance = mip.at(face, row, column);
                FourTexels& four = out[i / 4];
                four.x[i % 4] = frame.n.x;
                four.y[i % 4] = frame.n.y;
                four.z[i % 4] = frame.n.z;
                four.solid_angle[i % 4] = frame.solid_angle;
                four.red[i % 4] = radiance[0] * frame.solid_angle;
                four.green[i % 4] = radiance[1] * frame.solid_angle;
                four.blue[i % 4] = radiance[2] * frame.solid_angle;
            }
    return out;
}

float total(const Lanes& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

Lanes gathered(const std::vector<FourTexels>& sources, const math::Vec3& n, float alpha) {
    const Lanes zero{};
    // D to a factor, with (n.h)^2 = (1 + n.l) / 2: 1 / ((n.h)^2 (alpha^2 - 1) + 1)^2.
    const float slope = 0.5F * (alpha * alpha - 1.0F);
    Lanes weight{};
    Lanes red{};
    Lanes green{};
    Lanes blue{};
    for (const FourTexels& four : sources) {
        const Lanes cosine = n.x * four.x + n.y * four.y + n.z * four.z;
        const Lanes n_dot_l = cosine > zero ? cosine : zero;
        const Lanes denominator = (1.0F + slope) + slope * cosine;
        const Lanes share = n_dot_l / (denominator * denominator);
        weight += share * four.solid_angle;
        red += share * four.red;
        green += share * four.green;
        blue += share * four.blue;
    }
    const float scale = 1.0F / total(weight);
    return Lanes{total(red) * scale, total(green) * scale, total(blue) * scale, 0.0F};
}

}  // namespace

CubeMip through_wide_lobe(const CubePyramid& pyramid, std::uint32_t side, float alpha,
                          base::ThreadPool& pool) {
    const auto source = std::find_if(pyramid.mips.begin(), pyramid.mips.end(),
                                     [](const CubeMip& mip) { return mip.side == source_px; });
    const std::vector<FourTexels> sources = sources_of(*source);
    CubeMip out = make_mip(side);
    pool.parallel_for(std::size_t{6} * side, [&](std::size_t task) {
        const auto face = static_cast<std::uint32_t>(task / side);
        const std::size_t row = task % side;
        for (std::size_t column = 0; column < side; ++column)
            out.at(face, row, column) =
                gathered(sources, texel_frame(face, row, column, side).n, alpha);
    });
    fill_borders(out);
    return out;
}

}  // namespace facet::frame
