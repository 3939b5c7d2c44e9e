// What every reader asks of a header before it allocates, and the errors they share.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"
#include "image/image.h"
#include "image/read.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace facet::image {

/// Size as a file states it: wider than Extent, so that nothing has wrapped yet.
struct StatedSize {
    std::uint64_t width = 0;
    std::uint64_t height = 0;
};
/// Size 0, side, area and memory. `bytes_per_pixel` is all that decoding holds at once.
/// Errors: input_invalid (size 0), limit_reached.
[[nodiscard]] base::Status check_size(const StatedSize& size, std::uint64_t bytes_per_pixel,
                                      const base::Limits& limits);

/// `input_invalid` at a byte offset; `found` may be empty.
[[nodiscard]] tl::unexpected<base::Error> damaged(std::size_t offset, std::string what,
                                                  std::string found = {});
/// `feature_missing`: a variant of a format that no reader here has.
[[nodiscard]] tl::unexpected<base::Error> unsupported(std::string what, std::string found = {});

/// A picture of one unnamed layer, channels called Y, Y A, R G B or R G B A by their count.
[[nodiscard]] Picture one_layer(tables::ImageFormat format, Image image);

/// The image as u8 or u16, rescaled where it has the other depth. Errors: internal for f32.
[[nodiscard]] base::Result<Image> with_integer_depth(const Image& image, Sample sample);

/// Where an ICC profile calls itself sRGB: its description holds the word, in ASCII or UTF-16.
[[nodiscard]] bool names_srgb(std::string_view icc_profile);
/// The warning for a picture whose colours are in another space than sRGB and are used as they
/// stand.
[[nodiscard]] base::Warning foreign_color_space(std::string found);

}  // namespace facet::image
