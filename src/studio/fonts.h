// The letters of the user interface.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace facet::studio {

struct Fonts {
    bool has_cyrillic = false;
};

/// Fills ImGui's atlas with letters of `size_px`: DejaVu, Noto or Liberation where one is
/// installed, else ImGui's own, which has Latin letters only.
[[nodiscard]] Fonts load_fonts(float size_px);

}  // namespace facet::studio
