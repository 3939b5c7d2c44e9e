// The command line, through CLI11; the only file of `facet` that names it.
// SPDX-License-Identifier: MIT
#include "cli/parse.h"

#include "base/text.h"

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::cli {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

template <class... Ts>
struct Overloaded : Ts... {
    using Ts::operator()...;
};

/// What was given for one flag; numbers are read when all is known, so that the message can be
/// ours.
struct Given {
    const Flag* flag;
    std::vector<std::string> texts;
    bool on = false;
};

/// Makes CLI11 fill `given`. Lists take one value a time, so that `--set a=1 SCENE` leaves SCENE
/// alone.
void add_flag(CLI::App& app, Given& given) {
    const Flag& flag = *given.flag;
    if (std::holds_alternative<bool*>(flag.target)) {
        app.add_flag(flag.names, given.on)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
        return;
    }
    CLI::Option* option = app.add_option(flag.names, given.texts);
    if (!flag.is_argument()) option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    const bool is_list = std::holds_alternative<std::vector<std::string>*>(flag.target);
    if (!is_list) option->expected(1);
    if (!is_list || !flag.is_argument()) option->allow_extra_args(false);
}

base::Status store(const Given& given) {
    const Flag& flag = *given.flag;
    if (std::holds_alternative<bool*>(flag.target)) {
        if (given.on) *std::get<bool*>(flag.target) = true;
        return {};
    }
    if (given.texts.empty()) return {};
    const std::string& last = given.texts.back();  // of several, the last one counts
    if (auto* const* text = std::get_if<std::string*>(&flag.target)) **text = last;
    if (auto* const* list = std::get_if<std::vector<std::string>*>(&flag.target))
        **list = given.texts;
    if (const auto* bounded = std::get_if<BoundedNumber>(&flag.target)) {
        const auto number = base::parse_number(last);
        if (!number || *number < bounded->range.low || *number > bounded->range.high)
            return fail({.code = ErrorCode::usage,
                         .file = std::string(flag.long_name()),
                         .what = fmt::format("takes a number from {} to {}", bounded->range.low,
                                             bounded->range.high),
                         .found = last});
        *bounded->number = *number;
    }
    return {};
}

std::vector<std::string> long_names(std::span<const Flag> flags) {
    std::vector<std::string> names;
    for (const Flag& flag : flags)
        if (!flag.is_argument()) names.emplace_back(flag.long_name());
    return names;
}

std::string did_you_mean(std::span<const std::string> close, std::string_view otherwise) {
    return close.empty() ? std::string(otherwise) : "did you mean " + base::join(close, ", ");
}

base::Error unknown_option(std::string_view option, const NamedCommand* command,
                           std::span<const Flag> shared) {
    const std::string_view name = option.substr(0, option.find('='));
    std::vector<std::string> names = long_names(shared);
    if (command != nullptr)
        for (std::string& other : long_names(command->declared.flags))
            names.push_back(std::move(other));
    const std::string help =
        command == nullptr ? "facet --help" : fmt::format("facet {} --help", command->name);
    return {.code = ErrorCode::usage,
            .file = std::string(name),
            .what = "unknown option",
            .remedy = did_you_mean(base::nearest(name, names), help + " lists them")};
}

base::Error unexpected(std::string_view word, const NamedCommand* command,
                       std::span<const NamedCommand> commands) {
    if (command != nullptr)
        return {.code = ErrorCode::usage,
                .file = std::string(word),
                .what = "one argument too many",
                .remedy = fmt::format("facet {} --help", command->name)};
    std::vector<std::string> names;
    for (const NamedCommand& other : commands) names.emplace_back(other.name);
    return {.code = ErrorCode::usage,
            .file = std::string(word),
            .what = "unknown command",
            .remedy = did_you_mean(base::nearest(word, names), "facet --help lists them")};
}

/// CLI11's complaint in our words: which option, and what it lacks.
base::Error in_our_words(const CLI::ParseError& error) {
    const std::string text = error.what();
    const std::string name = text.substr(0, text.find(':'));
    const bool is_option = name.starts_with('-') && name.find(' ') == std::string::npos;
    if (is_option && dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
        return {.code = ErrorCode::usage, .file = name, .what = "needs a value"};
    return {.code = ErrorCode::usage,
            .file = is_option ? name : "",
            .what = "the command line is not understood",
            .found = text,
            .remedy = "facet --help"};
}

/// One parser: the root or a command, with what it was given.
struct Level {
    CLI::App* app;
    std::vector<Given> given;

    void declare(CLI::App& at, std::span<const Flag> flags) {
        app = &at;
        given.reserve(flags.size());  // CLI11 keeps pointers into it
        for (const Flag& flag : flags) add_flag(at, given.emplace_back(Given{&flag, {}, false}));
    }
    [[nodiscard]] base::Status store_all() const {
        for (const Given& one : given)
            if (auto stored = store(one); !stored) return stored;
        return {};
    }
};

}  // namespace

Result<const NamedCommand*> parse(std::span<const std::string> arguments,
                                  std::span<const Flag> shared,
                                  std::span<const NamedCommand> commands) {
    CLI::App root;
    root.set_help_flag();
    root.fallthrough();
    root.allow_extras();
    root.require_subcommand(0, 1);
    Level top;
    top.declare(root, shared);
    std::vector<Level> levels(commands.size());
    for (std::size_t i = 0; i < commands.size(); ++i)
        levels[i].declare(*root.add_subcommand(std::string(commands[i].name)),
                          commands[i].declared.flags);

    std::optional<base::Error> complaint;
    try {
        root.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& error) {
        complaint = in_our_words(error);
    }
    const NamedCommand* command = nullptr;
    Level* level = nullptr;
    for (std::size_t i = 0; i < commands.size(); ++i)
        if (levels[i].app->parsed()) command = &commands[i], level = &levels[i];
    // A misspelt option explains everything that went wrong after it, so it is told first.
    std::vector<std::string> rest = root.remaining(true);
    const auto end_of_options = std::ranges::find(rest, "--");
    const auto option = std::find_if(rest.begin(), end_of_options, [](const std::string& word) {
        return word.size() > 1 && word.starts_with('-');
    });
    if (option != end_of_options) return fail(unknown_option(*option, command, shared));
    if (complaint) return fail(*complaint);
    if (end_of_options != rest.end()) rest.erase(end_of_options);
    if (!rest.empty()) return fail(unexpected(rest.front(), command, commands));
    if (auto stored = top.store_all(); !stored) return tl::unexpected(stored.error());
    if (level != nullptr)
        if (auto stored = level->store_all(); !stored) return tl::unexpected(stored.error());
    return command;
}

}  // namespace facet::cli
