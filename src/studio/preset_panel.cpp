// Materials to begin with.
// SPDX-License-Identifier: MIT
#include "studio/preset_panel.h"

namespace facet::studio {

void draw_presets(PanelTools&, std::size_t) {}

}  // namespace facet::studio
