// Calls add_NAME of every command; the one expansion of commands.def besides its header.
// SPDX-License-Identifier: MIT
#include "cli/dispatch.h"

namespace facet::cli {

#define COMMAND(key, ...) void add_##key(Declaration& command);  // in cmd_NAME.cpp
#include "tables/commands.def"

std::vector<NamedCommand> declare_commands() {
    std::vector<NamedCommand> commands;
#define COMMAND(key, ...)                \
    commands.emplace_back().name = #key; \
    add_##key(commands.back().declared);
#include "tables/commands.def"
    return commands;
}

}  // namespace facet::cli
