// Reading pictures: what a file is by its first bytes, its header before its pixels, then the
// pixels. SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"
#include "image/image.h"
#include "tables/image_formats.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace facet::image {

/// What a header says, before any pixel is decoded.
struct Header {
    tables::ImageFormat format{};
    math::Extent size;
    std::uint32_t channels = 0;
    Sample sample = Sample::u8;
};

/// The format by magic bytes; nothing where it is no known picture. Names and endings are not
/// looked at.
[[nodiscard]] std::optional<tables::ImageFormat> sniff(std::span<const std::byte> file);

/// Header only; every limit is checked here. Errors: input_invalid (unknown, broken, size 0),
/// limit_reached (side, area, memory), feature_missing (a variant no reader has).
[[nodiscard]] base::Result<Header> read_header(std::span<const std::byte> file,
                                               const base::Limits& limits);

/// The pixels: PNG, JPEG, WebP, TIFF as u8 or u16 (stored transfer kept, straight alpha), HDR and
/// EXR as f32 linear. `channels` is that of the file (palettes are expanded to RGB or RGBA). NaN,
/// infinite and negative values of HDR and EXR become 0, with one warning each that has the count.
/// Errors: as read_header, and input_invalid for truncated or damaged pixels; never partial pixels.
[[nodiscard]] base::Result<Image> decode(std::span<const std::byte> file,
                                         const base::Limits& limits, base::Warnings& warnings);

/// One named set of channels of a picture: EXR layers, and the one unnamed layer of other formats.
struct Layer {
    std::string name;                   ///< "" for beauty; "normal" for normal.X …
    std::vector<std::string> channels;  ///< "R","G","B","A" or "X","Y","Z" or "Z" or "Y"
    Image image;
};
/// A layer whose channels are named by a letter each.
[[nodiscard]] Layer layer_of(std::string_view name, std::string_view letters, Image image);
/// A picture with everything in it: layers, and text metadata.
struct Picture {
    std::vector<Layer> layers;
    std::vector<std::pair<std::string, std::string>> metadata;
    tables::ImageFormat format{};
};
/// Like decode, but keeps every EXR layer (values as stored, NaN and infinities too) and the
/// metadata.
[[nodiscard]] base::Result<Picture> decode_picture(std::span<const std::byte> file,
                                                   const base::Limits& limits);

}  // namespace facet::image
