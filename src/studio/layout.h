// Where the panels are.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/config.h"
#include "studio/panels.h"

namespace facet::studio {

/// Draws every panel between the menu and the status line. Returns the viewport's size in pixels of
/// the screen.
[[nodiscard]] math::Extent draw_panels(PanelTools& tools, Layout& layout);

}  // namespace facet::studio
