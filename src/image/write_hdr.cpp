// Writes Radiance pictures: RGBE with new run lengths.
// SPDX-License-Identifier: MIT
#include "image/bytes.h"
#include "image/checks.h"
#include "image/dispatch.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace facet::image::hdr {
namespace {

using Byte = std::uint8_t;

/// Shared exponent by Ward 1991: mantissas are v * 256 / 2^e, cut, with 2^e just above the largest
/// channel.
std::array<Byte, 4> to_rgbe(float r, float g, float b) {
    const auto usable = [](float v) { return v > 0.0F ? std::min(v, 1e38F) : 0.0F; };  // NaN -> 0
    r = usable(r);
    g = usable(g);
    b = usable(b);
    const float largest = std::max({r, g, b});
    if (largest < 1e-32F) return {};
    // 2^exponent, the power of two just above `largest`, read off its bits: std::frexp costs ten
    // times as much.
    const int exponent = static_cast<int>(std::bit_cast<std::uint32_t>(largest) >> 23) - 126;
    const auto scale = std::bit_cast<float>(static_cast<std::uint32_t>(127 + 8 - exponent) << 23);
    return {static_cast<Byte>(r * scale), static_cast<Byte>(g * scale),
            static_cast<Byte>(b * scale), static_cast<Byte>(exponent + 128)};
}

/// Runs of 4 and more, up to 127; what lies between them goes as it is, up to 128 at a time.
void append_plane(base::Bytes& out, std::span<const Byte> plane) {
    const auto run_at = [&](std::size_t at) {
        std::size_t length = 1;
        while (at + length < plane.size() && length < 127 && plane[at + length] == plane[at])
            ++length;
        return length;
    };
    std::size_t at = 0;
    while (at < plane.size()) {
        std::size_t literal_end = at;
        std::size_t run = run_at(literal_end);
        while (literal_end < plane.size() && run < 4) {
            literal_end += run;
            run = literal_end < plane.size() ? run_at(literal_end) : 0;
        }
        while (at < literal_end) {
            const std::size_t count = std::min<std::size_t>(literal_end - at, 128);
            out.push_back(static_cast<std::byte>(count));
            append(out, std::as_bytes(plane.subspan(at, count)));
            at += count;
        }
        if (run >= 4 && at < plane.size()) {
            out.push_back(static_cast<std::byte>(128 + run));
            out.push_back(static_cast<std::byte>(plane[at]));
            at += run;
        }
    }
}

void append_scanline(base::Bytes& out, std::span<const Byte> planes, std::size_t width) {
    if (width < 8 || width >= 32768) {  // no run lengths at such widths
        for (std::size_t x = 0; x < width; ++x)
            for (std::size_t c = 0; c < 4; ++c)
                out.push_back(static_cast<std::byte>(planes[c * width + x]));
        return;
    }
    for (const std::size_t byte : {std::size_t{2}, std::size_t{2}, width >> 8, width & 0xFF})
        out.push_back(static_cast<std::byte>(byte));
    for (std::size_t c = 0; c < 4; ++c) append_plane(out, planes.subspan(c * width, width));
}

std::string preamble(const Image& image, const WriteOptions& options) {
    std::string text = "#?RADIANCE\n";
    for (const auto& [key, entry] : options.metadata) {
        // The header has lines only, and an empty one ends it.
        const bool is_one_line = entry.find('\n') == std::string::npos && entry.size() < 4000;
        const bool is_plain = key.find_first_of("=\n#") == std::string::npos && !key.empty() &&
                              key != "FORMAT" && key != "EXPOSURE" && key != "COLORCORR";
        if (is_one_line && is_plain) text += key + "=" + entry + "\n";
    }
    return text + fmt::format("FORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.size.height,
                              image.size.width);
}

}  // namespace

base::Result<base::Bytes> write(std::span<const Layer> layers, const WriteOptions& options) {
    const Image& image = layers.front().image;
    if (image.sample != Sample::f32)
        return base::fail({.code = base::ErrorCode::internal,
                           .what = "an HDR picture was asked for from integer pixels"});
    const std::size_t width = image.size.width;
    const std::size_t channels = image.channels;
    const std::size_t green = channels >= 3 ? 1 : 0;
    const std::size_t blue = channels >= 3 ? 2 : 0;
    const auto values = image.as<float>();
    base::Bytes out;
    out.reserve(values.size() * 2);
    append(out, preamble(image, options));
    std::vector<Byte> planes(width * 4);
    for (std::size_t y = 0; y < image.size.height; ++y) {
        const float* row = values.data() + y * width * channels;
        for (std::size_t x = 0; x < width; ++x) {
            const float* pixel = row + x * channels;
            const auto rgbe = to_rgbe(pixel[0], pixel[green], pixel[blue]);
            for (std::size_t c = 0; c < 4; ++c) planes[c * width + x] = rgbe[c];
        }
        append_scanline(out, planes, width);
    }
    return out;
}

}  // namespace facet::image::hdr
