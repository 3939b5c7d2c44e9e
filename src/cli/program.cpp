// Arguments to exit status: the shared options, help, lists, and the command's job.
// SPDX-License-Identifier: MIT
#include "cli/program.h"

#include "base/cache_folder.h"
#include "base/text.h"
#include "cli/dispatch.h"
#include "cli/help.h"
#include "cli/lists.h"
#include "cli/setting_flags.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <cstdlib>
#include <optional>

namespace facet::cli {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

/// What every command takes.
struct Shared {
    bool help = false;
    bool version = false;
    bool json = false;
    bool quiet = false;
    bool verbose = false;
    std::string color = "auto";
    std::string list;

    [[nodiscard]] std::vector<Flag> flags() {
        return {{"-h,--help", &help, "", "", "this page, or a command's"},
                {"--version", &version, "", "", "the version of the program and of its files"},
                {"--json", &json, "", "", "results as one JSON object a line"},
                {"-q,--quiet", &quiet, "", "", "errors only"},
                {"-v,--verbose", &verbose, "", "", "what is done, with sizes and times"},
                {"--color", &color, "auto|always|never", "",
                 "colours on standard error; NO_COLOR is honoured"},
                {"--list", &list, "WHAT", "", "the names there are: " + list_names()}};
    }
};

base::Status apply(const Shared& shared, Io& io) {
    io.json = shared.json;
    if (shared.quiet && shared.verbose)
        return fail({.code = ErrorCode::usage, .file = "--quiet", .what = "excludes --verbose"});
    io.quiet = shared.quiet;
    if (shared.verbose) io.level = base::LogLevel::debug;
    const std::string& color = shared.color;
    if (color != "auto" && color != "always" && color != "never")
        return fail({.code = ErrorCode::usage,
                     .file = "--color",
                     .what = "is one of auto, always, never",
                     .found = color});
    const char* no_color = std::getenv("NO_COLOR");
    const bool wanted = (no_color == nullptr || *no_color == '\0') && ::isatty(STDERR_FILENO) == 1;
    io.color = color == "always" || (color == "auto" && wanted);
    return {};
}

void print_version(Io& io) {
    if (io.json)
        io.print_object(nlohmann::ordered_json{{"facet", 1}, {"version", FACET_VERSION}});
    else
        io.print("facet " FACET_VERSION);
}

/// Pages end in a newline of their own, and print() adds one.
std::string page(std::string text) {
    if (text.ends_with('\n')) text.pop_back();
    return text;
}

Result<Exit> run(std::span<const std::string> arguments, char** environment, Io& io) {
    Shared shared;
    const std::vector<Flag> flags = shared.flags();
    const std::vector<NamedCommand> commands = declare_commands();
    const auto parsed = parse(arguments, flags, commands);
    // Even a mistake in the arguments is told the way they ask for.
    if (!parsed) {
        for (const std::string& argument : arguments) io.json = io.json || argument == "--json";
        return tl::unexpected(parsed.error());
    }
    if (auto applied = apply(shared, io); !applied) return tl::unexpected(applied.error());
    const NamedCommand* command = *parsed;
    if (shared.version) return print_version(io), Exit::done;
    if (shared.help) {
        io.print(page(command == nullptr ? general_help(flags) : command_help(*command)));
        return Exit::done;
    }
    if (!shared.list.empty()) return print_list(shared.list, command, io);
    if (command == nullptr) {
        io.note(page(general_help(flags)));
        return fail({.code = ErrorCode::usage, .what = "no command given"});
    }
    if (auto checked = base::check_cache_variable(); !checked)
        return tl::unexpected(checked.error());
    io.warn(unknown_environment(environment), false);
    return command->declared.job(io);
}

}  // namespace

int run_program(std::span<const std::string> arguments, char** environment, Io& io) {
    const Result<Exit> exit = run(arguments, environment, io);
    if (!exit) io.complain(exit.error());
    // The reader of our output went away, or its disk is full: there is nobody to tell.
    if (!io.finish()) return static_cast<int>(Exit::temporary);
    return exit ? static_cast<int>(*exit) : base::exit_code(exit.error().code);
}

}  // namespace facet::cli
