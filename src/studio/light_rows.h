// The lights of the scene: which there are, and a row for every value of the one selected.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/panels.h"

namespace facet::studio {

void draw_lights(PanelTools& tools);
/// Takes away light `light` of `light_count`, where it is one that the document added.
void remove_light(Editor& editor, std::size_t light_count, std::size_t light);

}  // namespace facet::studio
