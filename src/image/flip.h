// LDR-FLIP: the difference a person would see flipping between two pictures.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/image.h"

namespace facet::image {

/// Mean over all pixels, [0, 1], at 67 pixels per degree (0.7 m from a monitor 0.7 m and 3840 px
/// wide). Both f32 [height, width, 4], sRGB-encoded [0, 1], of one size; alpha is not looked at.
/// Source: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference
/// Evaluator for Alternating Images", HPG 2020.
[[nodiscard]] double mean_flip(const Image& a, const Image& b);

}  // namespace facet::image
