// A lesson's Markdown as HTML: text, tables, formulas, and the figures that it names.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace facet::teach {

/// `![caption](kind:name)`: what stands there. Caption is plain text.
struct Figure {
    std::string kind;
    std::string name;
    std::string caption;
};
/// Makes a figure's HTML. `is_inline`: within a line of text.
using FigureMaker = std::function<base::Result<std::string>(const Figure& figure)>;

/// CommonMark with tables and $formulas$; no raw HTML, links to https and http only. The first
/// heading is left out: it is the page's title. Errors: input_invalid (a formula, a link), the
/// figure's own.
[[nodiscard]] base::Result<std::string> html_of(std::string_view markdown,
                                                const FigureMaker& figure);

/// Every figure that the text names, in order.
[[nodiscard]] std::vector<Figure> figures_of(std::string_view markdown);
/// What stands in fenced blocks of the language `sh`, a block each.
[[nodiscard]] std::vector<std::string> shell_blocks(std::string_view markdown);

/// Plain text: a line for each paragraph and item, of the section whose heading is the `index`-th
/// of the second level. Formulas as LaTeX; no figures.
[[nodiscard]] std::vector<std::string> plain_section(std::string_view markdown, std::size_t index);

}  // namespace facet::teach
