// The menu above, and the line of text below.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/panels.h"

namespace facet::studio {

void draw_menu(PanelTools& tools);
void draw_status(PanelTools& tools);

}  // namespace facet::studio
