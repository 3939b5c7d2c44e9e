// Rows for the settings of a picture, generated from tables/settings.def.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/panels.h"

#include <string_view>

namespace facet::studio {

/// Every setting of the table's group that a picture in the studio has.
void draw_settings_group(PanelTools& tools, std::string_view group);

}  // namespace facet::studio
