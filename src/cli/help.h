// The pages that --help prints, made from what the commands declare.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/flags.h"
#include "cli/parse.h"

#include <span>
#include <string>

namespace facet::cli {

/// `facet --help`: an example, the commands, the options that all of them take.
[[nodiscard]] std::string general_help(std::span<const Flag> shared);
/// `facet NAME --help`: an example, then every option in its group, a line each.
[[nodiscard]] std::string command_help(const NamedCommand& command);
/// The lines `facet help TOPIC` prints. Errors: usage, for a topic that is not there.
[[nodiscard]] base::Result<std::string> topic_help(const std::string& topic);

}  // namespace facet::cli
