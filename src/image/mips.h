// Textures for the GPU: 8-bit RGBA of any picture, and its mip levels.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "image/image.h"
#include "tables/material.h"

#include <vector>

namespace facet::image {

/// u8 RGBA of a picture of any channels and sample: gray goes to R, G and B, missing alpha is 255,
/// u16 is rounded, f32 is clamped to [0, 1] and rounded. The transfer function stays as it is. Free
/// when it is u8 RGBA.
[[nodiscard]] Image to_rgba8(Image image);

/// The picture and all its mip levels down to 1x1, each half the size of the one before, rounded
/// down: u8 [height, width, 4], the mean of the pixels beneath (odd sides: of the parts beneath).
/// With `srgb` R, G and B are averaged in linear light and encoded again; alpha never is.
/// Precondition: u8, 4 channels, not empty.
[[nodiscard]] std::vector<Image> build_mips(Image rgba8, bool srgb);
/// The same levels, rows spread over the pool. Not from a task of the pool.
[[nodiscard]] std::vector<Image> build_mips(Image rgba8, bool srgb, base::ThreadPool& pool);
/// The levels of a map of a material: these, or of normals build_normal_mips().
[[nodiscard]] std::vector<Image> build_mips(Image rgba8, tables::Texels texels);

}  // namespace facet::image
