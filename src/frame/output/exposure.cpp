// Automatic exposure.
// SPDX-License-Identifier: MIT
#include "frame/output/exposure.h"

#include "math/color.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace facet::frame {
namespace {

constexpr std::size_t chunk = 4096;
constexpr double key = 0.18;
constexpr float darkest_share = 1e-4F;

struct Sum {
    double value = 0.0;
    std::size_t count = 0;
};

/// Sums `of(luminance)` over the pixels of at least `least` that `depth` covers, or over all; chunk
/// by chunk, in order.
template <class Of>
Sum sum(std::span<const float> radiance, std::span<const float> depth, bool all, float least,
        base::ThreadPool& pool, const Of& of) {
    std::vector<Sum> parts((depth.size() + chunk - 1) / chunk);
    pool.parallel_for(parts.size(), [&](std::size_t part) {
        const std::size_t end = std::min(depth.size(), (part + 1) * chunk);
        for (std::size_t i = part * chunk; i < end; ++i) {
            if (!all && depth[i] >= 1.0F) continue;
            const float y =
                math::luminance({radiance[i * 4], radiance[i * 4 + 1], radiance[i * 4 + 2]});
            if (!std::isfinite(y) || y < least) continue;
            parts[part].value += of(y);
            ++parts[part].count;
        }
    });
    Sum total;
    for (const Sum& part : parts) {
        total.value += part.value;
        total.count += part.count;
    }
    return total;
}

}  // namespace

double auto_exposure(std::span<const float> radiance, std::span<const float> depth,
                     std::uint32_t frame_count, base::ThreadPool& pool) {
    const auto identity = [](float y) { return static_cast<double>(y); };
    bool all = false;
    Sum luminance = sum(radiance, depth, all, 0.0F, pool, identity);
    if (luminance.count == 0) {
        all = true;
        luminance = sum(radiance, depth, all, 0.0F, pool, identity);
    }
    const double mean =
        luminance.count == 0 ? 0.0 : luminance.value / static_cast<double>(luminance.count);
    if (!(mean > 0.0)) return 1.0;
    const float darkest = static_cast<float>(mean) * darkest_share;
    const Sum logs = sum(radiance, depth, all, darkest, pool,
                         [&](float y) { return static_cast<double>(std::log(y)); });
    const double log_average = std::exp(logs.value / static_cast<double>(logs.count));
    return key / (log_average / static_cast<double>(frame_count));
}

}  // namespace facet::frame
