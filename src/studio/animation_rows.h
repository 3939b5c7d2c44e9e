// Rows of what a file has more than one of: its animations, and sets of its materials.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/panels.h"

namespace facet::studio {

/// Which animation is played, its time, and a button that lets it go on. Nothing where the file has
/// none.
void draw_animation(PanelTools& tools);
/// Which variant of its materials (KHR_materials_variants). Nothing where the file has none.
void draw_variants(PanelTools& tools);

}  // namespace facet::studio
