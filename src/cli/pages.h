// What an installed program brings for others to read: a man page and shell completions.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/parse.h"

#include <span>
#include <string>

namespace facet::cli {

/// facet.1, in roff, with every command and option.
[[nodiscard]] std::string man_page(std::span<const NamedCommand> commands);
/// Completion for bash: commands, options, files.
[[nodiscard]] std::string bash_completion(std::span<const NamedCommand> commands);

}  // namespace facet::cli
