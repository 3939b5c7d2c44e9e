// The colours and distances of the user interface.
// SPDX-License-Identifier: MIT
#pragma once

namespace facet::studio {

enum class Theme { dark, light };

/// Sets ImGui's style. `scale`: pixels of the screen to one of the design.
void apply_theme(Theme theme, float scale);

}  // namespace facet::studio
