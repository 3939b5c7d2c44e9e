// PNG files of every kind, written by libpng: what the program itself does not write.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "math/vector.h"

#include <png.h>

#include <cstdint>
#include <vector>

namespace facet::test {

struct PngKind {
    int color_type = PNG_COLOR_TYPE_RGB;
    int bit_depth = 8;
    bool interlaced = false;
    bool has_transparency = false;
};

/// Rows of packed samples as the format has them: [height][bytes of a row].
using PngRows = std::vector<std::vector<std::uint8_t>>;

/// Palette of `1 << bit_depth` entries: entry i is (i, 255 - i, 3 i). tRNS: entries 0 and 1 have
/// alpha 10 and 20; gray or colour: sample value 1 (all channels) is transparent. No error
/// handling: a fault here fails the test.
inline base::Bytes write_png_kind(const PngKind& kind, math::Extent size, PngRows rows) {
    base::Bytes out;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &out,
        [](png_structp p, png_bytep data, png_size_t count) {
            auto& to = *static_cast<base::Bytes*>(png_get_io_ptr(p));
            const auto* bytes = reinterpret_cast<const std::byte*>(data);
            to.insert(to.end(), bytes, bytes + count);
        },
        nullptr);
    png_set_IHDR(png, info, size.width, size.height, kind.bit_depth, kind.color_type,
                 kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, 0, 0);
    if (kind.color_type == PNG_COLOR_TYPE_PALETTE) {
        std::vector<png_color> palette;
        for (int i = 0; i < 1 << kind.bit_depth; ++i)
            palette.push_back({static_cast<png_byte>(i), static_cast<png_byte>(255 - i),
                               static_cast<png_byte>(3 * i)});
        png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    }
    if (kind.has_transparency) {
        const png_byte alphas[2] = {10, 20};
        const png_color_16 key{1, 1, 1, 1, 1};
        png_set_tRNS(png, info, alphas, 2, &key);
    }
    png_write_info(png, info);
    std::vector<png_bytep> pointers;
    for (auto& row : rows) pointers.push_back(row.data());
    png_write_image(png, pointers.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return out;
}

}  // namespace facet::test
