// Calls add_NAME of every command; the one expansion of commands.def besides its header.
// SPDX-License-Identifier: MIT
#include "cli/dispatch.h"

#include "tables/commands.h"

namespace facet::cli {

#define COMMAND(key, ...) void add_##key(Declaration& command);  // in cmd_NAME.cpp
#include "tables/commands.def"

std::vector<NamedCommand> declare_commands() {
    std::vector<NamedCommand> commands;
#define COMMAND(name, ...)   \
    commands.emplace_back(); \
    add_##name(commands.back().declared);
#include "tables/commands.def"
    for (std::size_t i = 0; i < commands.size(); ++i) commands[i].name = tables::commands[i].key;
    return commands;
}

}  // namespace facet::cli
