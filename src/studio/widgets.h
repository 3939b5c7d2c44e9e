// Widgets for rows of the tables: one number or colour, as a step of undo.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/editor.h"
#include "studio/ui.h"
#include "tables/describe.h"

#include <string>

namespace facet::studio {

/// What a slider shows.
struct SliderSpec {
    std::string name;  ///< registered as this
    std::string label;
    std::string help;
    std::string unit;
    tables::Range range;   ///< values beyond are not taken
    tables::Range slider;  ///< its ends
    bool logarithmic = false;
    bool changed = false;  ///< differs from the scene as opened: a button puts it back
};

enum class Touched { no, changed, reset };

/// A labelled slider for `value`; a number can be typed after Ctrl+click.
[[nodiscard]] Touched number_row(Ui& ui, const SliderSpec& spec, float& value);
/// A labelled check box.
[[nodiscard]] Touched toggle_row(Ui& ui, const SliderSpec& spec, bool& on);
/// A labelled colour; linear Rec.709. Its popup takes sRGB, linear numbers, #rrggbb and a
/// temperature.
[[nodiscard]] Touched color_row(Ui& ui, const SliderSpec& spec, math::Vec3& linear);
/// A labelled choice among names; `chosen` is the index.
[[nodiscard]] bool choice_row(Ui& ui, const std::string& name, std::string_view label,
                              std::string_view help, std::size_t& chosen,
                              const std::vector<std::string>& names);

}  // namespace facet::studio
