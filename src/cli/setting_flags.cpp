// The settings of a picture as options.
// SPDX-License-Identifier: MIT
#include "cli/setting_flags.h"

#include "base/limits.h"
#include "base/text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace facet::cli {
namespace {

using base::ErrorCode;
using base::fail;
using base::Status;
using tables::Setting;
using tables::Settings;

tl::unexpected<base::Error> refuse(const Setting& row, std::string what, std::string found,
                                   std::string remedy = "") {
    return fail({.code = ErrorCode::usage,
                 .file = flag_name(row.key),
                 .what = std::move(what),
                 .found = std::move(found),
                 .remedy = std::move(remedy)});
}

std::string variable_name(const Setting& row) {
    std::string name = "FACET_";
    for (const char c : row.key)
        name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return name;
}
bool has_variable(const Setting& row) { return row.group == "Machine"; }

/// "8|16|half|float" as a list; nothing where a part stands for something (NAME, X,Y,WxH).
std::vector<std::string> choices(std::string_view value) {
    std::vector<std::string> out;
    for (const std::string_view part : base::split(value, '|')) {
        const bool literal = !part.empty() && std::ranges::all_of(part, [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
        });
        if (!literal) return {};
        out.emplace_back(part);
    }
    return out;
}

Status assign_number(const Setting& row, const std::string& text, double& number) {
    const auto parsed = base::parse_number(text);
    if (!parsed) return refuse(row, fmt::format("takes a number ({})", row.value), text);
    if (*parsed < row.range.low || *parsed > row.range.high)
        return refuse(
            row,
            fmt::format("is out of range: {} to {} ({})", row.range.low, row.range.high, row.value),
            text);
    number = *parsed;
    return {};
}

/// Reads one text into the field that a row points to.
struct Assign {
    Settings& settings;
    const Setting& row;
    const std::vector<std::string>& texts;

    [[nodiscard]] const std::string& last() const { return texts.back(); }
    [[nodiscard]] Status refuse_size() const {
        return refuse(row, "takes a width and a height in pixels, as 1280x720", last());
    }

    Status operator()(tables::Extent Settings::*field) const {
        const auto parts = base::split(last(), 'x');
        if (parts.size() != 2) return refuse_size();
        const long long width = base::parse_integer(parts[0]).value_or(0);
        const long long height = base::parse_integer(parts[1]).value_or(0);
        if (width < 1 || height < 1) return refuse_size();
        const long long most = base::Limits{}.image_side_px;
        if (width > most || height > most)
            return fail({.code = ErrorCode::limit_reached,
                         .file = flag_name(row.key),
                         .what = fmt::format("a side of a picture is at most {} pixels", most),
                         .found = last()});
        settings.*field = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
        return {};
    }
    Status operator()(tables::Text Settings::*field) const {
        const auto allowed = choices(row.value);
        if (!allowed.empty() && std::ranges::find(allowed, last()) == allowed.end()) {
            const auto close = base::nearest(last(), allowed);
            return refuse(row, "is one of " + base::join(allowed, ", "), last(),
                          close.empty() ? "" : "did you mean " + close.front());
        }
        settings.*field = last();
        return {};
    }
    Status operator()(tables::Number Settings::*field) const {
        double number = 0;
        if (auto read = assign_number(row, last(), number); !read) return read;
        settings.*field = static_cast<float>(number);
        return {};
    }
    Status operator()(tables::OptionalNumber Settings::*field) const {
        double number = 0;
        if (auto read = assign_number(row, last(), number); !read) return read;
        settings.*field = static_cast<float>(number);
        return {};
    }
    Status operator()(tables::Count Settings::*field) const {
        const auto number = base::parse_integer(last());
        if (!number || static_cast<double>(*number) < row.range.low ||
            static_cast<double>(*number) > row.range.high)
            return refuse(row,
                          fmt::format("takes a whole number from {:.0f} to {:.0f}", row.range.low,
                                      row.range.high),
                          last());
        settings.*field = static_cast<tables::Count>(*number);
        return {};
    }
    Status operator()(tables::Flag Settings::*field) const {
        if (last() != "0" && last() != "1") return refuse(row, "is 0 or 1", last());
        settings.*field = last() == "1";
        return {};
    }
    Status operator()(tables::List Settings::*field) const {
        for (const std::string& text : texts) {
            if (row.repeatable) {
                (settings.*field).push_back(text);
                continue;
            }
            for (const std::string_view part : base::split(text, ','))
                if (!base::trimmed(part).empty())
                    (settings.*field).emplace_back(base::trimmed(part));
        }
        return {};
    }
};

}  // namespace

std::string flag_name(std::string_view key) {
    std::string name = "--" + std::string(key);
    std::ranges::replace(name, '_', '-');
    return name;
}

Status assign(Settings& settings, const Setting& row, const std::vector<std::string>& texts) {
    if (texts.empty()) return {};
    return std::visit(Assign{settings, row, texts}, row.field);
}

void TypedSettings::declare(std::vector<Flag>& flags,
                            const std::function<bool(const Setting&)>& wanted) {
    for (std::size_t i = 0; i < tables::settings.size(); ++i) {
        const Setting& row = tables::settings[i];
        if (wanted && !wanted(row)) continue;
        Flag flag{.names = flag_name(row.key),
                  .target = &texts[i],
                  .value = std::string(row.value),
                  .group = std::string(row.group),
                  .help = std::string(row.help)};
        if (std::holds_alternative<tables::Flag Settings::*>(row.field)) flag.target = &switches[i];
        flags.push_back(std::move(flag));
    }
}

base::Result<Settings> TypedSettings::read() const {
    Settings settings;
    for (std::size_t i = 0; i < tables::settings.size(); ++i) {
        const Setting& row = tables::settings[i];
        std::vector<std::string> given = texts[i];
        if (switches[i]) given = {"1"};
        const std::string variable = variable_name(row);
        const char* set =
            has_variable(row) && given.empty() ? std::getenv(variable.c_str()) : nullptr;
        if (set != nullptr && *set != '\0') given = {set};
        if (auto read = assign(settings, row, given); !read) {
            base::Error error = read.error();
            if (set != nullptr) error.file = variable;
            return fail(std::move(error));
        }
    }
    return settings;
}

base::Warnings unknown_environment(char** environment) {
    std::vector<std::string> known{"FACET_SHADER_CACHE"};
    for (const Setting& row : tables::settings)
        if (has_variable(row)) known.push_back(variable_name(row));
    base::Warnings warnings;
    for (char** entry = environment; entry != nullptr && *entry != nullptr; ++entry) {
        const std::string_view text = *entry;
        const std::string_view name = text.substr(0, text.find('='));
        if (!name.starts_with("FACET_") || std::ranges::find(known, name) != known.end()) continue;
        const auto close = base::nearest(name, known);
        warnings.push_back(
            {.file = std::string(name),
             .what = "this environment variable is ignored",
             .remedy = close.empty() ? "" : "did you mean " + base::join(close, ", ")});
    }
    return warnings;
}

}  // namespace facet::cli
