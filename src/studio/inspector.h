// The inspector: numbers, lobes and energy of the pixel under the mouse, and the histogram.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/panels.h"

namespace facet::studio {

void draw_inspector(PanelTools& tools);

}  // namespace facet::studio
