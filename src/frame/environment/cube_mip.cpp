// Borders of a cube map's faces.
// SPDX-License-Identifier: MIT
#include "frame/environment/cube_mip.h"

#include <algorithm>
#include <utility>

namespace facet::frame {
namespace {

/// The texel of another face that touches this face's edge at (row, column), one of them -1 or
/// `side`.
Lanes across_edge(const CubeMip& mip, std::uint32_t face, std::ptrdiff_t row,
                  std::ptrdiff_t column) {
    const auto place = [&](std::ptrdiff_t i) {
        return (static_cast<float>(i) + 0.5F) / static_cast<float>(mip.side) * 2.0F - 1.0F;
    };
    const math::CubePoint other = math::cube_point_from(
        math::direction_from(math::CubePoint{face, place(column), place(row)}));
    const auto index = [&](float x) {
        const float i = (x + 1.0F) * 0.5F * static_cast<float>(mip.side);
        return std::min(static_cast<std::size_t>(std::max(i, 0.0F)), std::size_t{mip.side} - 1);
    };
    return mip.at(other.face, index(other.t), index(other.s));
}

}  // namespace

CubeMip make_mip(std::uint32_t side) {
    CubeMip mip{.side = side, .texels = {}};
    mip.texels.resize(6 * mip.stride() * mip.stride());
    return mip;
}

void fill_borders(CubeMip& mip) {
    const auto side = static_cast<std::ptrdiff_t>(mip.side);
    for (std::uint32_t face = 0; face < 6; ++face) {
        Lanes* const texels = mip.texels.data() + face * mip.stride() * mip.stride();
        const auto at = [&](std::ptrdiff_t row, std::ptrdiff_t column) -> Lanes& {
            return texels[(row + 1) * (side + 2) + column + 1];
        };
        for (std::ptrdiff_t i = 0; i < side; ++i) {
            at(-1, i) = across_edge(mip, face, -1, i);
            at(side, i) = across_edge(mip, face, side, i);
            at(i, -1) = across_edge(mip, face, i, -1);
            at(i, side) = across_edge(mip, face, i, side);
        }
        // Three faces meet at a corner: the fourth texel is the mean of their three
        // (OpenGL 4.5, 8.14.3).
        using Ends = std::array<std::pair<std::ptrdiff_t, std::ptrdiff_t>, 2>;
        const Ends ends = {{{-1, 0}, {side, side - 1}}};  // outside, inside
        for (const auto& [row, inner_row] : ends)
            for (const auto& [column, inner] : ends)
                at(row, column) = (at(inner_row, column) + at(row, inner) + at(inner_row, inner)) *
                                  lanes_of(1.0F / 3.0F);
    }
}

}  // namespace facet::frame
