// The inspector.
// SPDX-License-Identifier: MIT
#include "studio/inspector.h"

namespace facet::studio {

void draw_inspector(PanelTools&) {}

}  // namespace facet::studio
