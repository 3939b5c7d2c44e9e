// A texture, small enough for a panel.
// SPDX-License-Identifier: MIT
#include "studio/texture_preview.h"

#include "image/mips.h"

#include <algorithm>
#include <array>

namespace facet::studio {
namespace {

/// The mean code of each channel over the box.
std::array<std::uint32_t, 4> mean(const image::Image& rgba, std::uint32_t x0, std::uint32_t y0,
                                  std::uint32_t x1, std::uint32_t y1) {
    const auto codes = rgba.as<std::uint8_t>();
    std::array<std::uint64_t, 4> sums{};
    for (std::uint32_t y = y0; y < y1; ++y)
        for (std::uint32_t x = x0; x < x1; ++x)
            for (std::size_t c = 0; c < 4; ++c)
                sums[c] += codes[(std::size_t{y} * rgba.size.width + x) * 4 + c];
    const std::uint64_t count = std::uint64_t{x1 - x0} * (y1 - y0);
    std::array<std::uint32_t, 4> out{};
    for (std::size_t c = 0; c < 4; ++c) out[c] = static_cast<std::uint32_t>(sums[c] / count);
    return out;
}

}  // namespace

image::Image preview(const image::Image& image, Channel channel, std::uint32_t side_px) {
    const image::Image rgba = image::to_rgba8(image);
    const std::uint32_t longest = std::max(rgba.size.width, rgba.size.height);
    const std::uint32_t step = std::max(1U, (longest + side_px - 1) / side_px);
    const math::Extent size{std::max(1U, rgba.size.width / step),
                            std::max(1U, rgba.size.height / step)};
    image::Image out(size, 3, image::Sample::u8);
    const auto codes = out.as<std::uint8_t>();
    for (std::uint32_t y = 0; y < size.height; ++y)
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const auto at =
                mean(rgba, x * step, y * step, std::min(rgba.size.width, (x + 1) * step),
                     std::min(rgba.size.height, (y + 1) * step));
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t from =
                    channel == Channel::all ? c : static_cast<std::size_t>(channel) - 1;
                codes[(std::size_t{y} * size.width + x) * 3 + c] =
                    static_cast<std::uint8_t>(at[from]);
            }
        }
    return out;
}

}  // namespace facet::studio
