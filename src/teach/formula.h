// Formulas: the part of LaTeX that lessons write, as MathML that browsers set.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"

#include <string>
#include <string_view>

namespace facet::teach {

/// A `<math>` element; `display`: on a line of its own, sums with their limits above and below.
/// Knows letters, numbers, operators, ^ _ { }, \frac \sqrt \left \right \text \mathbf \mathrm \vec
/// \hat \bar \operatorname, Greek, common functions and symbols, and \begin{aligned} with & and \\.
/// Errors: input_invalid, naming what it does not know.
[[nodiscard]] base::Result<std::string> mathml(std::string_view latex, bool display);

/// The same as a line of text: "4 (n·v)(n·l)". Fractions and roots are not drawn.
[[nodiscard]] std::string plain_formula(std::string_view latex);

}  // namespace facet::teach
