// The chunks of a PNG file, bounded: header, transparency, text, colour space, and where the pixels
// lie. SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"
#include "image/dispatch.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace facet::image::png {

/// Colour types of the PNG specification (W3C 2003, 11.2.2).
enum class ColorType : std::uint8_t { gray = 0, rgb = 2, palette = 3, gray_alpha = 4, rgba = 6 };

struct Chunks {
    math::Extent size;
    std::uint8_t bit_depth = 0;
    ColorType color_type = ColorType::gray;
    bool interlaced = false;
    bool has_transparency = false;  ///< a tRNS chunk
    bool is_animated = false;       ///< an acTL chunk (APNG)
    bool is_srgb = false;           ///< an sRGB chunk
    std::string color_space;        ///< what else the file says of its colours; empty when sRGB
    std::vector<std::pair<std::string, std::string>> text;
    std::vector<FileBytes> pixels;  ///< the IDAT chunks' bodies

    /// Of the decoded picture: palettes and tRNS expanded, 1 to 8 bits as u8.
    [[nodiscard]] std::uint32_t channels() const noexcept;
    [[nodiscard]] Sample sample() const noexcept {
        return bit_depth == 16 ? Sample::u16 : Sample::u8;
    }
};

/// How far to look: up to the first pixel, or to the end of the file.
enum class Scope { header, whole };

/// Views into `file`. Checks size limits and the checksums of IHDR and IDAT. Errors: input_invalid,
/// limit_reached.
[[nodiscard]] base::Result<Chunks> find_chunks(FileBytes file, Scope scope,
                                               const base::Limits& limits);

/// Pixels of a plain file (8 or 16 bits, no palette, no tRNS, not interlaced), about three times as
/// quick as libpng. Nothing where the file is not plain or its data are odd: libpng then decides.
[[nodiscard]] std::optional<Image> read_plain(const Chunks& chunks);

}  // namespace facet::image::png
