// A lesson's plot as SVG.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/svg_figure.h"
#include "teach/lesson.h"

#include <string>
#include <string_view>

namespace facet::teach {

/// The curves computed, labels in `language`.
[[nodiscard]] image::Figure figure_of(const Plot& plot, std::string_view language,
                                      Answers& answers);
[[nodiscard]] std::string svg_of(const Plot& plot, std::string_view language, Answers& answers);

/// A number as its lesson writes it: "0.5853", "14.2 %".
[[nodiscard]] std::string written(const Number& number, double value);

}  // namespace facet::teach
