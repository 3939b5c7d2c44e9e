// FLIP: the difference a person would see flipping between two pictures, in low and in high dynamic
// range. SPDX-License-Identifier: MIT
#pragma once

#include "image/image.h"

#include <vector>

namespace facet::image {

/// Error by pixel, f32 [height, width, 1] in [0, 1], at 67 pixels per degree (0.7 m from a monitor
/// 0.7 m and 3840 px wide). Both f32 [height, width, 4], sRGB-encoded [0, 1], of one size; alpha is
/// not looked at. Source: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP:
/// A Difference Evaluator for Alternating Images", HPG 2020.
[[nodiscard]] Image flip_map(const Image& a, const Image& b);

/// The exposures that HDR-FLIP looks at, as powers of two: from where the brightest pixel of
/// `reference` is shown at 0.85 to where its median is, a step of one apart or a little less, two
/// at least. Empty where the picture is black.
[[nodiscard]] std::vector<float> flip_exposures(const Image& reference);

/// The largest FLIP error of each pixel over those exposures, tone mapped by ACES. Both f32
/// [height, width, 4], linear Rec.709, finite, not negative. Where the reference is black all over:
/// 0 where the other is, else 1. Source: Andersson, Nilsson, Shirley, Akenine-Moller, "Visualizing
/// Errors in Rendered High Dynamic Range Images", Eurographics 2021, Sections 3 and 4.
[[nodiscard]] Image hdr_flip_map(const Image& reference, const Image& test);

/// Mean of a map.
[[nodiscard]] double mean_of(const Image& map);

}  // namespace facet::image
