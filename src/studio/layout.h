// Where the panels are: their widths, which a person can drag.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/panels.h"

namespace facet::studio {

/// In points of the design.
struct Layout {
    float left = 270.0F;
    float right = 350.0F;
    float bottom = 190.0F;
};

/// Draws every panel between the menu and the status line. Returns the viewport's size in pixels of
/// the screen.
[[nodiscard]] math::Extent draw_panels(PanelTools& tools, Layout& layout);

}  // namespace facet::studio
