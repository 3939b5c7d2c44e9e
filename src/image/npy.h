// Arrays for NumPy.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "image/image.h"

namespace facet::image {

enum class NpyType { f32, u32 };

/// A .npy file, version 1.0 (numpy.lib.format), little-endian, C order: shape (height, width) for
/// one channel, else (height, width, channels). `image` is f32; `u32` rounds its numbers, which are
/// then whole and not below 0.
[[nodiscard]] base::Bytes encode_npy(const Image& image, NpyType type);

}  // namespace facet::image
