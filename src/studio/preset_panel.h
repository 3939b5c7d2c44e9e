// Materials to begin with: resources/materials, and files of the user's own.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/panels.h"

namespace facet::studio {

/// A button that opens the presets; choosing one replaces the values of `material`.
void draw_presets(PanelTools& tools, std::size_t material);

}  // namespace facet::studio
