// The textures of a material: what is there, channel by channel, and taking one off.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/panels.h"

namespace facet::studio {

void draw_texture_rows(PanelTools& tools, std::size_t material);

}  // namespace facet::studio
