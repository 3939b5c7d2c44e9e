// The command line, read into what the commands declared.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "cli/flags.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facet::cli {

/// A command with its name.
struct NamedCommand {
    std::string_view name;
    Declaration declared;
};

/// Reads `arguments` (without the program's name) into the targets of `shared` (options that every
/// command takes, in any place) and of the command that is named first. Returns that command, or
/// null where none is. Errors: usage, for an unknown command or option with the nearest right ones,
/// and for a value that is missing, no number, or out of range.
[[nodiscard]] base::Result<const NamedCommand*> parse(std::span<const std::string> arguments,
                                                      std::span<const Flag> shared,
                                                      std::span<const NamedCommand> commands);

}  // namespace facet::cli
