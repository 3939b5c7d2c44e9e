// Pictures side by side with captions: what `facet render --compare` shows.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/image.h"

#include <span>
#include <string>
#include <vector>

namespace facet::image {

/// One picture, u8 or u16 RGB or RGBA as a screen shows it, and lines of text for below it.
struct Panel {
    const Image* picture = nullptr;
    std::vector<std::string> lines;
};

/// u8 RGB: the panels from left to right, a gap between, and a dark strip below each with its lines
/// in a dotted font of printable ASCII (others show as a box), as large as fits the width. Alpha is
/// laid over mid gray. Precondition: at least one panel; all of one size.
[[nodiscard]] Image side_by_side(std::span<const Panel> panels);

}  // namespace facet::image
