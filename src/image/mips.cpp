// Mip levels by a 2x2 box in linear light, in integers.
// SPDX-License-Identifier: MIT
#include "image/mips.h"

#include "base/assert.h"
#include "image/checks.h"
#include "image/mip_taps.h"
#include "image/normal_mips.h"
#include "math/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace facet::image {
namespace {

using Byte = std::uint8_t;

/// 8-bit code -> linear 0..65535, and the sum of four of those, / 16, -> 8-bit code. 14 bits keep
/// five steps to the narrowest code (the dark end of sRGB), so a constant colour stays what it is.
struct Tables {
    std::array<std::uint16_t, 256> linear{};
    std::array<Byte, 16384> code{};
};

Tables make_tables(bool srgb) {
    Tables tables;
    for (std::size_t i = 0; i < tables.linear.size(); ++i) {
        const float code = static_cast<float>(i) / 255.0F;
        tables.linear[i] = static_cast<std::uint16_t>(
            std::lround((srgb ? math::linear_from_srgb(code) : code) * 65535.0F));
    }
    for (std::size_t i = 0; i < tables.code.size(); ++i) {
        const float linear = (static_cast<float>(i) + 0.5F) / 16384.0F;
        tables.code[i] = static_cast<Byte>(
            std::lround((srgb ? math::srgb_from_linear(linear) : linear) * 255.0F));
    }
    return tables;
}
/// Made once, on first use, and never changed.
const Tables& tables_of(bool srgb) {
    static const Tables encoded = make_tables(true);
    static const Tables plain = make_tables(false);
    return srgb ? encoded : plain;
}

void halve_row_srgb(const Byte* top, const Byte* bottom, Byte* out, std::size_t width) {
    const Tables& t = tables_of(true);
    for (std::size_t x = 0; x < width; ++x, top += 8, bottom += 8, out += 4) {
        for (std::size_t c = 0; c < 3; ++c) {
            const unsigned sum = 0U + t.linear[top[c]] + t.linear[top[c + 4]] +
                                 t.linear[bottom[c]] + t.linear[bottom[c + 4]];
            out[c] = t.code[sum >> 4];
        }
        out[3] = static_cast<Byte>((top[3] + top[7] + bottom[3] + bottom[7] + 2) >> 2);
    }
}

void halve_row_linear(const Byte* top, const Byte* bottom, Byte* out, std::size_t width) {
    for (std::size_t x = 0; x < width; ++x, top += 8, bottom += 8, out += 4)
        for (std::size_t c = 0; c < 4; ++c)
            out[c] = static_cast<Byte>((top[c] + top[c + 4] + bottom[c] + bottom[c + 4] + 2) >> 2);
}

void halve_row_odd(const Image& from, Image& to, std::size_t y, bool srgb) {
    const Tables& color = tables_of(srgb);
    const Tables& alpha = tables_of(false);
    const Taps down = taps(from.size.height, to.size.height, y);
    const Byte* in = from.as<Byte>().data();
    Byte* out = to.as<Byte>().data() + y * to.size.width * 4;
    for (std::size_t x = 0; x < to.size.width; ++x) {
        const Taps across = taps(from.size.width, to.size.width, x);
        for (std::size_t c = 0; c < 4; ++c) {
            const Tables& table = c == 3 ? alpha : color;
            float sum = 0.0F;
            for (std::size_t j = 0; j < 3; ++j)
                for (std::size_t i = 0; i < 3; ++i)
                    sum +=
                        down.share[j] * across.share[i] *
                        static_cast<float>(
                            table
                                .linear[in[(down.at[j] * from.size.width + across.at[i]) * 4 + c]]);
            out[x * 4 + c] =
                table.code[std::min<std::size_t>(static_cast<std::size_t>(sum * 0.25F), 16383)];
        }
    }
}

using Loop = std::function<void(std::size_t, const std::function<void(std::size_t)>&)>;

Image halved(const Image& from, bool srgb, const Loop& loop) {
    Image to({std::max(1U, from.size.width / 2), std::max(1U, from.size.height / 2)}, 4,
             Sample::u8);
    const bool is_even = from.size.width % 2 == 0 && from.size.height % 2 == 0;
    constexpr std::size_t band_rows = 32;
    const std::size_t rows = to.size.height;
    loop((rows + band_rows - 1) / band_rows, [&](std::size_t band) {
        const std::size_t end = std::min(rows, (band + 1) * band_rows);
        for (std::size_t y = band * band_rows; y < end; ++y) {
            if (!is_even) {
                halve_row_odd(from, to, y, srgb);
                continue;
            }
            const std::size_t stride = std::size_t{from.size.width} * 4;
            const Byte* top = from.as<Byte>().data() + 2 * y * stride;
            Byte* out = to.as<Byte>().data() + y * to.size.width * 4;
            (srgb ? halve_row_srgb : halve_row_linear)(top, top + stride, out, to.size.width);
        }
    });
    return to;
}

std::vector<Image> mips(Image rgba8, bool srgb, const Loop& loop) {
    FACET_ASSERT(rgba8.sample == Sample::u8 && rgba8.channels == 4 && rgba8.size.pixels() > 0);
    std::vector<Image> levels;
    levels.push_back(std::move(rgba8));
    while (levels.back().size.pixels() > 1) levels.push_back(halved(levels.back(), srgb, loop));
    return levels;
}

Image with_8_bits(const Image& image) {
    Image out(image.size, image.channels, Sample::u8);
    const auto to = out.as<Byte>();
    if (image.sample == Sample::f32) {
        const auto from = image.as<float>();
        for (std::size_t i = 0; i < from.size(); ++i) {
            const float v = from[i] > 0.0F ? std::min(from[i], 1.0F) : 0.0F;  // NaN -> 0
            to[i] = static_cast<Byte>(v * 255.0F + 0.5F);
        }
    } else {
        const auto from = image.as<std::uint16_t>();
        for (std::size_t i = 0; i < from.size(); ++i)
            to[i] = static_cast<Byte>((std::uint32_t{from[i]} * 255U + 32895U) >> 16);
    }
    return out;
}

}  // namespace

Image to_rgba8(Image image) {
    if (image.sample != Sample::u8) image = with_8_bits(image);
    if (image.channels == 4) return image;
    Image out(image.size, 4, Sample::u8);
    const std::size_t channels = image.channels;
    const std::size_t green = channels >= 3 ? 1 : 0;
    const std::size_t blue = channels >= 3 ? 2 : 0;
    const Byte* in = image.as<Byte>().data();
    Byte* to = out.as<Byte>().data();
    const std::size_t pixels = static_cast<std::size_t>(image.size.pixels());
    for (std::size_t i = 0; i < pixels; ++i, in += channels, to += 4) {
        to[0] = in[0];
        to[1] = in[green];
        to[2] = in[blue];
        to[3] = channels == 2 ? in[1] : Byte{255};
    }
    return out;
}

std::vector<Image> build_mips(Image rgba8, bool srgb) {
    return mips(std::move(rgba8), srgb, [](std::size_t count, const auto& task) {
        for (std::size_t i = 0; i < count; ++i) task(i);
    });
}

std::vector<Image> build_mips(Image rgba8, bool srgb, base::ThreadPool& pool) {
    return mips(std::move(rgba8), srgb,
                [&pool](std::size_t count, const auto& task) { pool.parallel_for(count, task); });
}

std::vector<Image> build_mips(Image rgba8, tables::Texels texels) {
    if (texels == tables::Texels::normals) return build_normal_mips(std::move(rgba8));
    return build_mips(std::move(rgba8), texels == tables::Texels::colors);
}

}  // namespace facet::image
