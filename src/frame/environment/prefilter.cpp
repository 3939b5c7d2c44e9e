// Prefiltered radiance.
// SPDX-License-Identifier: MIT
#include "frame/environment/prefilter.h"

#include "frame/environment/gaussian_pyramid.h"
#include "frame/environment/lobe.h"
#include "frame/environment/wide_lobe.h"

#include <algorithm>
#include <cmath>

namespace facet::frame {
namespace {

/// Above this roughness squared a lobe is wide: 0.4 rad to half its peak, which is several texels
/// of the mip that wide_lobe.cpp sums over.
constexpr float wide_alpha = 0.3F;
/// Where the finest Gaussian lies: GGX's peak is as curved as a Gaussian of sigma = alpha; most of
/// its parts are wider (see below).
constexpr float finest_over_alpha = 0.75F;
/// Wider than that a Gaussian reaches below the horizon; the wide lobes stand in.
constexpr float widest_sigma_rad = 0.7F;

/// One map that a lobe can be mixed from, and its lobe.
struct Part {
    CubeMip map;
    LobeTable lobe;
};

std::vector<Part> gaussian_parts(const CubePyramid& pyramid, float narrowest_alpha,
                                 base::ThreadPool& pool) {
    std::vector<Part> parts;
    for (Blurred& blurred : make_gaussian_pyramid(pyramid, finest_over_alpha * narrowest_alpha,
                                                  widest_sigma_rad, pool)) {
        const auto sigma = static_cast<double>(blurred.sigma_rad);
        parts.push_back({std::move(blurred.map), tabulate([sigma](double theta) {
                             return std::exp(-theta * theta / (2.0 * sigma * sigma));
                         })});
    }
    return parts;
}

/// 1 / (1 + x)^2, which GGX is near its peak, is the integral of t exp(-t) exp(-t x) over t: a
/// mixture of Gaussians of all widths. Octaves of them and the wide lobes come within a few percent
/// of it.
CubeMip mixed(const std::vector<Part>& parts, float alpha, std::uint32_t side,
              base::ThreadPool& pool) {
    std::vector<LobeTable> lobes;
    for (const Part& part : parts) lobes.push_back(part.lobe);
    const LobeTable whole =
        tabulate([&](double theta) { return lobe_weight(theta, static_cast<double>(alpha)); });
    const std::vector<float> weights = mixture_of(whole, lobes);
    CubeMip out = make_mip(side);
    pool.parallel_for(std::size_t{6} * side, [&](std::size_t task) {
        const auto face = static_cast<std::uint32_t>(task / side);
        const std::size_t row = task % side;
        for (std::size_t column = 0; column < side; column += 4) {
            FourDirections d{};
            for (std::size_t i = 0; i < 4; ++i) {
                const math::Vec3 n = math::direction_from(
                    math::CubePoint{face, texel_center(column + i, side), texel_center(row, side)});
                d.x[i] = n.x;
                d.y[i] = n.y;
                d.z[i] = n.z;
            }
            std::array<Lanes, 4> sum{};
            for (std::size_t p = 0; p < parts.size(); ++p) {
                if (weights[p] == 0.0F) continue;
                const auto four = parts[p].map.sample(d);
                for (std::size_t i = 0; i < 4; ++i) sum[i] += four[i] * weights[p];
            }
            for (std::size_t i = 0; i < 4; ++i) out.at(face, row, column + i) = sum[i];
        }
    });
    return out;
}

}  // namespace

std::vector<CubeMip> prefilter(const CubePyramid& pyramid, std::uint32_t levels,
                               base::ThreadPool& pool) {
    const std::uint32_t face_px = pyramid.mips[0].side * 2;
    const auto alpha_of = [&](std::uint32_t level) {
        const float roughness = static_cast<float>(level) / static_cast<float>(levels - 1);
        return roughness * roughness;
    };
    std::vector<CubeMip> out(levels - 1);
    std::vector<Part> parts = gaussian_parts(pyramid, alpha_of(1), pool);
    for (std::uint32_t level = levels - 1; level > 0; --level) {
        const float alpha = alpha_of(level);
        const std::uint32_t side = face_px >> level;
        if (alpha > wide_alpha) {
            CubeMip map = through_wide_lobe(pyramid, side, alpha, pool);
            out[level - 1] = map;
            parts.push_back({std::move(map), tabulate([alpha](double theta) {
                                 return lobe_weight(theta, static_cast<double>(alpha));
                             })});
        } else {
            out[level - 1] = mixed(parts, alpha, side, pool);
            fill_borders(out[level - 1]);
        }
    }
    return out;
}

}  // namespace facet::frame
