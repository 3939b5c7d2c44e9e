// The pages of --help: an example first, then one line for each thing.
// SPDX-License-Identifier: MIT
#include "cli/help.h"

#include "base/text.h"
#include "tables/commands.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::cli {
namespace {

constexpr std::size_t name_column = 30;
constexpr std::size_t page_width = 110;

/// `  NAME   help`, the help cut to the page and continued below.
std::string line(std::string_view name, std::string_view help) {
    std::string out = fmt::format("  {:<{}}", name, name_column);
    if (name.size() >= name_column) out += "  ";
    const std::size_t room = page_width - std::min(page_width / 2, out.size());
    while (help.size() > room) {
        const std::size_t cut = help.substr(0, room).find_last_of(' ');
        if (cut == std::string_view::npos) break;
        out += fmt::format("{}\n{:<{}}", help.substr(0, cut), "", name_column + 2);
        help.remove_prefix(cut + 1);
    }
    return out + std::string(help) + "\n";
}

std::string title_of(const Flag& flag) {
    std::string names = flag.names;
    if (const std::size_t comma = names.find(','); comma != std::string::npos)
        names.replace(comma, 1, ", ");
    return flag.value.empty() ? names : fmt::format("{} {}", names, flag.value);
}

const tables::Command& row_of(std::string_view name) {
    return *std::ranges::find(tables::commands, name, &tables::Command::key);
}

}  // namespace

std::string general_help(std::span<const Flag> shared) {
    std::string out = fmt::format(
        "Example: {}\n\nFacet makes physically based pictures of glTF scenes, without a GPU or a "
        "display.\n\n"
        "Commands (facet COMMAND --help tells their options)\n",
        tables::commands.front().example);
    for (const tables::Command& command : tables::commands) out += line(command.key, command.help);
    out += "\nOptions of every command\n";
    for (const Flag& flag : shared) out += line(title_of(flag), flag.help);
    return out;
}

std::string command_help(const NamedCommand& command) {
    const tables::Command& row = row_of(command.name);
    std::string out = fmt::format("Example: {}\n\n{}: {}\n", row.example, row.usage, row.help);
    std::vector<std::string_view> groups;
    for (const Flag& flag : command.declared.flags)
        if (!flag.is_argument() && std::ranges::find(groups, flag.group) == groups.end())
            groups.push_back(flag.group);
    for (const Flag& flag : command.declared.flags)
        if (flag.is_argument()) out += line(flag.names, flag.help);
    for (const std::string_view group : groups) {
        out += fmt::format("{}\n", group);
        for (const Flag& flag : command.declared.flags)
            if (!flag.is_argument() && !flag.rare && flag.group == group)
                out += line(title_of(flag), flag.help);
    }
    return out +
           "--json -q -v --color --list WHAT: facet --help; exit codes: facet help exit-codes" +
           (std::ranges::any_of(command.declared.flags, &Flag::rare)
                ? "\n--max-memory, --allow-read, --strict and more: facet help more\n"
                : "\n");
}

}  // namespace facet::cli
