// The viewport: the picture, and how a person moves through it.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/panels.h"

namespace facet::studio {

/// Draws the bar above the picture and the picture into what is left of the window. Returns the
/// picture's size in pixels of the screen.
[[nodiscard]] math::Extent draw_viewport(PanelTools& tools);

}  // namespace facet::studio
