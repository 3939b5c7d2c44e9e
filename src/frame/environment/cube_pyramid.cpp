// The environment as a cube map and its mips.
// SPDX-License-Identifier: MIT
#include "frame/environment/cube_pyramid.h"

#include "frame/environment/resample.h"
#include "math/half.h"

#include <algorithm>
#include <array>

namespace facet::frame {
namespace {

constexpr std::uint32_t last_mip_px = 4;  // below that a bilinear sample sees half the sphere

/// Four texels into one, each by the solid angle it covers.
void halve_rows(const Lanes* upper, const Lanes* lower, std::uint32_t side, std::size_t row,
                Lanes* out) {
    const auto weight = [&](std::size_t x, std::size_t y) {
        return relative_solid_angle(texel_center(x, side), texel_center(y, side));
    };
    for (std::size_t x = 0; x < side; x += 2) {
        const float a = weight(x, row);
        const float b = weight(x + 1, row);
        const float c = weight(x, row + 1);
        const float d = weight(x + 1, row + 1);
        const Lanes sum = upper[x] * a + upper[x + 1] * b + lower[x] * c + lower[x + 1] * d;
        out[x / 2] = sum * (1.0F / (a + b + c + d));
    }
}

CubeMip halved(const CubeMip& finer) {
    CubeMip mip = make_mip(finer.side / 2);
    for (std::uint32_t face = 0; face < 6; ++face)
        for (std::size_t row = 0; row < mip.side; ++row)
            halve_rows(&finer.at(face, 2 * row, 0), &finer.at(face, 2 * row + 1, 0), finer.side,
                       2 * row, &mip.at(face, row, 0));
    fill_borders(mip);
    return mip;
}

}  // namespace

bool store_halves(const Lanes* row, std::size_t count, std::uint16_t* out) {
    Lanes most{};
    for (std::size_t i = 0; i < count; ++i) most = most > row[i] ? most : row[i];
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t lane = 0; lane < 3; ++lane) {
            const float x = row[i][lane];
            out[4 * i + lane] = math::half_from_radiance(x < math::half_max ? x : math::half_max);
        }
        out[4 * i + 3] = 0x3C00;  // 1
    }
    return std::max({most[0], most[1], most[2]}) > math::half_max;
}

CubePyramid make_cube_pyramid(const Panorama& panorama, std::uint32_t face_px, float rotation_deg,
                              base::ThreadPool& pool) {
    CubePyramid out;
    out.level0.resize(std::size_t{6} * face_px * face_px * 4);
    out.mips.push_back(make_mip(face_px / 2));
    const CubeResampler resampler(panorama, face_px, rotation_deg);
    constexpr std::array<std::uint32_t, 6> faces = {0, 1, 4, 5, 2, 3};  // the sides, then the poles
    const std::size_t pairs = face_px / 2;
    std::vector<std::uint8_t> overflowed(2 * pairs, 0);
    pool.parallel_for(2 * pairs, [&](std::size_t task) {
        const bool sides = task < pairs;
        const std::size_t row = task % pairs * 2;
        const std::size_t face_count = sides ? 4 : 2;
        std::vector<Lanes> texels(2 * face_count * face_px);
        for (std::size_t i = 0; i < 2; ++i) {
            Lanes* const rows = texels.data() + i * face_count * face_px;
            const auto y = static_cast<std::uint32_t>(row + i);
            sides ? resampler.side_rows(y, rows) : resampler.pole_rows(y, rows);
        }
        for (std::size_t f = 0; f < face_count; ++f) {
            const std::uint32_t face = faces[sides ? f : 4 + f];
            const Lanes* upper = texels.data() + f * face_px;
            const Lanes* lower = upper + face_count * face_px;
            halve_rows(upper, lower, face_px, row, &out.mips[0].at(face, row / 2, 0));
            std::uint16_t* halves =
                out.level0.data() + (std::size_t{face} * face_px + row) * face_px * 4;
            const bool a = store_halves(upper, face_px, halves);
            const bool b = store_halves(lower, face_px, halves + std::size_t{face_px} * 4);
            if (a || b) overflowed[task] = 1;
        }
    });
    out.overflowed =
        std::any_of(overflowed.begin(), overflowed.end(), [](auto flag) { return flag != 0; });
    fill_borders(out.mips[0]);
    while (out.mips.back().side > last_mip_px) {
        CubeMip next = halved(out.mips.back());
        out.mips.push_back(std::move(next));
    }
    return out;
}

}  // namespace facet::frame
