// What can be read off a shown picture.
// SPDX-License-Identifier: MIT
#include "studio/analysis.h"

#include <algorithm>
#include <cstdint>

namespace facet::studio {
namespace {

constexpr std::size_t codes_per_bin = 256 / Histogram::bin_count;
constexpr std::uint32_t stripe_px = 4;

bool is_high(const std::uint8_t* p) { return p[0] == 255 || p[1] == 255 || p[2] == 255; }
bool is_low(const std::uint8_t* p) { return p[0] == 0 && p[1] == 0 && p[2] == 0; }

}  // namespace

Histogram histogram(const image::Image& shown) {
    const auto codes = shown.as<std::uint8_t>();
    std::array<std::array<std::uint64_t, Histogram::bin_count>, 3> counts{};
    std::uint64_t total = 0;
    std::uint64_t high = 0;
    std::uint64_t low = 0;
    for (std::size_t i = 0; i + 3 < codes.size(); i += 4) {
        if (codes[i + 3] == 0) continue;
        ++total;
        high += is_high(&codes[i]) ? 1U : 0U;
        low += is_low(&codes[i]) ? 1U : 0U;
        for (std::size_t c = 0; c < 3; ++c) ++counts[c][codes[i + c] / codes_per_bin];
    }
    Histogram out;
    if (total == 0) return out;
    const auto share = [&](std::uint64_t count) {
        return static_cast<float>(count) / static_cast<float>(total);
    };
    for (std::size_t c = 0; c < 3; ++c)
        std::transform(counts[c].begin(), counts[c].end(), out.shares[c].begin(), share);
    out.clipped_high = share(high);
    out.clipped_low = share(low);
    return out;
}

image::Image clipping_overlay(const image::Image& shown) {
    image::Image out(shown.size, 4, image::Sample::u8);
    const auto from = shown.as<std::uint8_t>();
    const auto to = out.as<std::uint8_t>();
    for (std::uint32_t y = 0; y < shown.size.height; ++y)
        for (std::uint32_t x = 0; x < shown.size.width; ++x) {
            const std::size_t at = (std::size_t{y} * shown.size.width + x) * 4;
            if (from[at + 3] == 0 || (x + y) / stripe_px % 2 == 0) continue;
            if (is_high(&from[at])) {
                to[at] = 255;
                to[at + 3] = 255;
            } else if (is_low(&from[at])) {
                to[at + 1] = 90;
                to[at + 2] = 255;
                to[at + 3] = 255;
            }
        }
    return out;
}

}  // namespace facet::studio
