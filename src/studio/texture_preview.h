// A texture, small enough for a panel.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/image.h"

namespace facet::studio {

/// What a preview shows: the colours, or one channel as gray.
enum class Channel { all, red, green, blue, alpha };

/// u8 RGB, at most `side_px` wide and high, every pixel the mean of those it stands for. Codes are
/// shown as they are. Precondition: `image` has pixels.
[[nodiscard]] image::Image preview(const image::Image& image, Channel channel,
                                   std::uint32_t side_px);

}  // namespace facet::studio
