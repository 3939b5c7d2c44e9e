// Handles in the viewport for the selected light: arrows along the axes, and where it stands.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/panels.h"

namespace facet::studio {

/// Draws the lights and the handles over the viewport's picture. True while a handle is held.
[[nodiscard]] bool drag_gizmo(PanelTools& tools, math::Vec2 low_px, math::Vec2 size_px);

}  // namespace facet::studio
