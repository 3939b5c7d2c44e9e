// The chunks of a WebP file: its first picture, and what is around it.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "image/dispatch.h"

#include <cstdint>
#include <string>

namespace facet::image::webp {

/// Where the first frame lies on its canvas; `stream` is a WebP file of that frame alone.
struct FirstFrame {
    math::Extent canvas;
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    base::Bytes stream;
};
/// Precondition: the file has an ANIM chunk. Errors: input_invalid.
[[nodiscard]] base::Result<FirstFrame> first_frame(FileBytes file);

/// The body of the file's ICCP chunk; empty where there is none.
[[nodiscard]] FileBytes icc_profile(FileBytes file);

}  // namespace facet::image::webp
