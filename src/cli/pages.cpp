// The man page and the completions, from what the commands declare.
// SPDX-License-Identifier: MIT
#include "cli/pages.h"

#include "tables/commands.h"
#include "tables/exit_codes.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::cli {
namespace {

/// Text that roff takes as it stands: no dash becomes a hyphen, no dot or quote at a line's start a
/// request.
std::string roff(std::string_view text) {
    std::string out = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
    for (const char c : text) {
        if (c == '-' || c == '\\') out += '\\';
        out += c == '\\' ? 'e' : c;
    }
    return out;
}

std::string option_entry(const Flag& flag) {
    std::string names = flag.names;
    std::ranges::replace(names, ',', ' ');
    return fmt::format(".TP\n.B {} {}\n{}\n", roff(names), roff(flag.value), roff(flag.help));
}

}  // namespace

std::string man_page(std::span<const NamedCommand> commands) {
    std::string out =
        ".TH FACET 1\n.SH NAME\nfacet \\- physically based pictures of glTF scenes, without a GPU "
        "or a display\n"
        ".SH SYNOPSIS\n.B facet\n.I command\n[options]\n";
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const tables::Command& row = tables::commands[i];
        std::string name(row.key);
        std::ranges::transform(name, name.begin(),
                               [](char c) { return static_cast<char>(c - 'a' + 'A'); });
        out += fmt::format(".SH {}\n{}: {}\n.PP\nExample: {}\n", name, roff(row.usage),
                           roff(row.help), roff(row.example));
        for (const Flag& flag : commands[i].declared.flags) out += option_entry(flag);
    }
    out += ".SH EXIT STATUS\n";
    for (const tables::ExitRow& row : tables::exit_codes)
        out += fmt::format(".TP\n.B {}\n{}\n", row.number, roff(row.help));
    return out;
}

std::string bash_completion(std::span<const NamedCommand> commands) {
    std::string names;
    std::string cases;
    for (const NamedCommand& command : commands) {
        names += fmt::format("{} ", command.name);
        cases += fmt::format("        {}) options=\"", command.name);
        for (const Flag& flag : command.declared.flags)
            if (!flag.is_argument()) cases += fmt::format("{} ", flag.long_name());
        cases += "\" ;;\n";
    }
    return fmt::format(
        "# bash completion for facet\n_facet() {{\n"
        "    local word=${{COMP_WORDS[COMP_CWORD]}} options=''\n"
        "    if [[ $COMP_CWORD -eq 1 ]]; then\n"
        "        COMPREPLY=($(compgen -W '{}--help --version --list' -- \"$word\"))\n        "
        "return\n    fi\n"
        "    case ${{COMP_WORDS[1]}} in\n{}    esac\n"
        "    [[ $word == -* ]] && COMPREPLY=($(compgen -W \"$options --json --help\" -- "
        "\"$word\"))\n"
        "}}\ncomplete -o default -F _facet facet\n",
        names, cases);
}

}  // namespace facet::cli
