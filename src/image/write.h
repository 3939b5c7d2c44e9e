// Writing pictures: encoded to memory by format, then put in place whole.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "base/result.h"
#include "image/read.h"
#include "tables/gamuts.h"
#include "tables/image_formats.h"

#include <string>
#include <utility>
#include <vector>

namespace facet::image {

enum class Depth { u8, u16, half, f32 };

struct WriteOptions {
    tables::ImageFormat format = tables::ImageFormat::png;
    Depth depth = Depth::u8;  ///< must be one the format has (tables::image_formats)
    std::vector<std::pair<std::string, std::string>> metadata;  ///< PNG text, EXR string attributes
    tables::Gamut gamut = tables::Gamut::srgb;  ///< of the values (PNG alone has others than sRGB)
    bool fast = false;                          ///< prefer encoding speed to size
};

/// One picture: PNG, JPEG, WebP, TIFF of a u8 or u16 image (sRGB-encoded, straight alpha; JPEG
/// drops alpha over black), HDR of an f32 image (linear RGB). PNG says which
/// colours they are: sRGB, or cICP.
/// Deterministic bytes.
[[nodiscard]] base::Result<base::Bytes> encode(const Image& image, const WriteOptions& options);

/// EXR: one part, all layers, scanlines, ZIP (fast: none… whatever decodes everywhere and is
/// quickest). Layer "" gives plain R G B A; others NAME.CHANNEL. Depth half or f32; a layer with
/// depth.Z, position or ids (u32 stored exactly in f32) is f32 always. Precondition: all layers
/// have the same size, f32 samples.
[[nodiscard]] base::Result<base::Bytes> encode_exr(std::span<const Layer> layers,
                                                   const WriteOptions& options);

}  // namespace facet::image
