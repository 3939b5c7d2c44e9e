// A script that works the studio as a person would: reading it.
// SPDX-License-Identifier: MIT
#include "studio/script.h"

#include "base/text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <optional>

namespace facet::studio {
namespace {

struct VerbRow {
    std::string_view name;
    std::size_t least_words;
    std::size_t most_words;
};
/// In the order of Verb.
constexpr std::array<VerbRow, 13> verbs = {{{"set", 2, 16},
                                            {"click", 1, 1},
                                            {"drag", 2, 3},
                                            {"key", 1, 1},
                                            {"type", 1, 64},
                                            {"open", 1, 1},
                                            {"save", 1, 1},
                                            {"undo", 0, 0},
                                            {"redo", 0, 0},
                                            {"wait", 0, 1},
                                            {"truth", 1, 1},
                                            {"shot", 1, 1},
                                            {"quit", 0, 0}}};

/// Words between spaces; a part in double quotes is one word. Nothing for an open quote.
std::optional<std::vector<std::string>> words_of(std::string_view line) {
    std::vector<std::string> words;
    std::string word;
    bool quoted = false;
    bool any = false;
    for (const char c : line) {
        if (c == '"') {
            quoted = !quoted;
            any = true;
        } else if (!quoted && (c == ' ' || c == '\t' || c == '\r')) {
            if (any) words.push_back(std::exchange(word, {}));
            any = false;
        } else if (!quoted && c == '#' && !any) {
            break;
        } else {
            word += c;
            any = true;
        }
    }
    if (quoted) return std::nullopt;
    if (any) words.push_back(word);
    return words;
}

base::Result<ScriptStep> parse_step(std::vector<std::string> words) {
    const auto bad = [](std::string what, std::string found, std::string remedy) {
        return base::fail({.code = base::ErrorCode::usage,
                           .what = std::move(what),
                           .found = std::move(found),
                           .remedy = std::move(remedy)});
    };
    std::vector<std::string> names;
    for (std::size_t i = 0; i < verbs.size(); ++i) {
        names.emplace_back(verbs[i].name);
        if (verbs[i].name != words.front()) continue;
        const std::size_t count = words.size() - 1;
        if (count < verbs[i].least_words || count > verbs[i].most_words)
            return bad(fmt::format("{} takes {} to {} words", verbs[i].name, verbs[i].least_words,
                                   verbs[i].most_words),
                       fmt::format("{}", count), "facet studio --help");
        words.erase(words.begin());
        return ScriptStep{static_cast<Verb>(i), std::move(words), 0};
    }
    return bad("no such step", words.front(), base::suggestion(words.front(), names));
}

}  // namespace

base::Result<std::vector<ScriptStep>> parse_script(std::string_view text, const std::string& file) {
    std::vector<ScriptStep> steps;
    std::size_t number = 0;
    for (const std::string_view line : base::split(text, '\n')) {
        ++number;
        const std::string where = fmt::format("line {}", number);
        auto words = words_of(line);
        if (!words)
            return base::fail({.code = base::ErrorCode::usage,
                               .file = file,
                               .where = where,
                               .what = "a quote is not closed",
                               .found = std::string(line)});
        if (words->empty()) continue;
        auto step = parse_step(std::move(*words));
        if (!step) {
            base::Error error = step.error();
            error.file = file;
            error.where = where;
            return tl::unexpected(error);
        }
        step->line = number;
        steps.push_back(std::move(*step));
    }
    return steps;
}

}  // namespace facet::studio
