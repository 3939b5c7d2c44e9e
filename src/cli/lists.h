// --list WHAT: the names that an option can take.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io.h"
#include "cli/parse.h"

#include <string>

namespace facet::cli {

/// "scenes, environments, …": what can be listed.
[[nodiscard]] std::string list_names();

/// Prints the names, one a line, with what they mean. Cameras and materials are those of the scene
/// that `command` was given. Errors: usage, for a list that is not there.
[[nodiscard]] base::Result<Exit> print_list(const std::string& what, const NamedCommand* command,
                                            Io& io);

}  // namespace facet::cli
