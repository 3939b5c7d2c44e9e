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
/// Its key is the second word of its usage: a name of C++ has no dash.
[[nodiscard]] constexpr Command with_key(Command row) {
    const std::string_view words = row.usage.substr(row.usage.find(' ') + 1);
    row.key = words.substr(0, words.find(' '));
    return row;
}
inline constexpr auto commands = std::to_array<Command>({
#define COMMAND(name, ...) with_key({__VA_ARGS__}),
#include "tables/commands.def"
});

}  // namespace facet::tables
