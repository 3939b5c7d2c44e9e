// The menu above, and the line of text below.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/actions.h"
#include "studio/panels.h"

#include <optional>
#include <string>
#include <vector>

namespace facet::studio {

/// Gives what was chosen from the menu or by its keys. `recent`: scenes to open again.
[[nodiscard]] std::optional<Action> draw_menu(PanelTools& tools,
                                              const std::vector<std::string>& recent);
void draw_status(PanelTools& tools);

}  // namespace facet::studio
