// The commands: commands.def's expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace facet::tables {

/// One row of commands.def.
struct Command {
    std::string_view key;
    std::string_view usage;
    std::string_view example;  ///< one line that does something useful
    std::string_view help;
};
inline constexpr auto commands = std::to_array<Command>({
#define COMMAND(name, ...) {.key = #name, __VA_ARGS__},
#include "tables/commands.def"
});

}  // namespace facet::tables
