// The commands of tables/commands.def with the functions that declare them.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/parse.h"

#include <vector>

namespace facet::cli {

/// Every command, declared, in the table's order.
[[nodiscard]] std::vector<NamedCommand> declare_commands();

}  // namespace facet::cli
