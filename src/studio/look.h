// How the viewport shows the scene: which view of it, and beside what.
// SPDX-License-Identifier: MIT
#pragma once

#include "tables/aovs.h"

#include <string>
#include <vector>

namespace facet::studio {

/// One thing the viewport can show instead of the finished picture.
struct View {
    std::string key;                ///< "beauty", an AOV's key, or the name of a sum
    std::vector<tables::Aov> aovs;  ///< added up; none for the finished picture
    bool furnace = false;           ///< white walls that shine 1 nit: energy lost shows as gray
};
/// The finished picture, sums of light paths, the furnace, and every row of tables/aovs.def.
[[nodiscard]] const std::vector<View>& views();
/// The view of that key; the finished picture where there is none.
[[nodiscard]] const View& view_by_key(const std::string& key);

/// What stands on the right of the wipe.
enum class Beside { nothing, original, reference, difference };

struct Look {
    std::string view = "beauty";
    Beside beside = Beside::nothing;
    float wipe = 0.5F;  ///< share of the width that shows the edited picture
    bool clipping = false;
    bool solo = false;  ///< other materials are gray
    bool frame = true;  ///< the output's edges
    bool operator==(const Look&) const = default;
};

}  // namespace facet::studio
