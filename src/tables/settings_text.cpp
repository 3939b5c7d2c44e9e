// The settings of a picture as texts, and back.
// SPDX-License-Identifier: MIT
#include "tables/settings_text.h"

#include "base/limits.h"
#include "base/text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::tables {
namespace {

using base::ErrorCode;
using base::fail;
using base::Status;

tl::unexpected<base::Error> refuse(const Setting& row, std::string what, std::string found,
                                   std::string remedy = "") {
    return fail({.code = ErrorCode::usage,
                 .file = flag_name(row.key),
                 .what = std::move(what),
                 .found = std::move(found),
                 .remedy = std::move(remedy)});
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

/// 1/125, as shutters are written, as a decimal number; another text as it is.
std::string as_decimal(const std::string& text) {
    const auto parts = base::split(text, '/');
    if (parts.size() != 2) return text;
    const auto above = base::parse_number(parts[0]);
    const auto below = base::parse_number(parts[1]);
    return above && below && *below != 0.0 ? fmt::format("{}", *above / *below) : text;
}

/// Reads one text into the field that a row points to.
struct Assign {
    Settings& values;
    const Setting& row;
    const std::vector<std::string>& texts;

    [[nodiscard]] const std::string& last() const { return texts.back(); }
    [[nodiscard]] Status refuse_size() const {
        return refuse(row, "takes a width and a height in pixels, as 1280x720", last());
    }

    Status operator()(Extent Settings::*field) const {
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
        values.*field = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
        return {};
    }
    Status operator()(Text Settings::*field) const {
        const auto allowed = choices(row);
        if (!allowed.empty() && std::ranges::find(allowed, last()) == allowed.end()) {
            const auto close = base::nearest(last(), allowed);
            return refuse(row, "is one of " + base::join(allowed, ", "), last(),
                          close.empty() ? "" : "did you mean " + close.front());
        }
        values.*field = last();
        return {};
    }
    Status operator()(Number Settings::*field) const {
        double number = 0;
        if (auto read = assign_number(row, last(), number); !read) return read;
        values.*field = static_cast<float>(number);
        return {};
    }
    Status operator()(OptionalNumber Settings::*field) const {
        double number = 0;
        if (auto read = assign_number(row, as_decimal(last()), number); !read) return read;
        values.*field = static_cast<float>(number);
        return {};
    }
    Status operator()(Count Settings::*field) const {
        const auto number = base::parse_integer(last());
        if (!number || static_cast<double>(*number) < row.range.low ||
            static_cast<double>(*number) > row.range.high)
            return refuse(row,
                          fmt::format("takes a whole number from {:.0f} to {:.0f}", row.range.low,
                                      row.range.high),
                          last());
        values.*field = static_cast<Count>(*number);
        return {};
    }
    Status operator()(Flag Settings::*field) const {
        if (last() != "0" && last() != "1") return refuse(row, "is 0 or 1", last());
        values.*field = last() == "1";
        return {};
    }
    Status operator()(List Settings::*field) const {
        (values.*field).clear();
        for (const std::string& text : texts) {
            if (row.repeatable) {
                (values.*field).push_back(text);
                continue;
            }
            for (const std::string_view part : base::split(text, ','))
                if (!base::trimmed(part).empty()) (values.*field).emplace_back(base::trimmed(part));
        }
        return {};
    }
};

/// The texts of one field.
struct Texts {
    std::vector<std::string> operator()(const Extent& size) const {
        return {fmt::format("{}x{}", size.width, size.height)};
    }
    std::vector<std::string> operator()(const Text& text) const { return {text}; }
    std::vector<std::string> operator()(Number number) const { return {fmt::format("{}", number)}; }
    std::vector<std::string> operator()(const OptionalNumber& number) const {
        if (!number) return {};
        return {fmt::format("{}", *number)};
    }
    std::vector<std::string> operator()(Count count) const { return {fmt::format("{}", count)}; }
    std::vector<std::string> operator()(Flag on) const { return {on ? "1" : "0"}; }
    std::vector<std::string> operator()(const List& list) const { return list; }
};

/// A word as a shell takes it: in single quotes where it holds anything else than these.
std::string quoted(const std::string& word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./:,=+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string out = "'";
    for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

}  // namespace

std::vector<std::string> choices(const Setting& row) {
    std::vector<std::string> out;
    for (const std::string_view part : base::split(row.value, '|')) {
        const bool literal = !part.empty() && std::ranges::all_of(part, [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
        });
        if (!literal) return {};
        out.emplace_back(part);
    }
    return out;
}

std::string flag_name(std::string_view key) {
    std::string name = "--" + std::string(key);
    std::ranges::replace(name, '_', '-');
    return name;
}

Status assign(Settings& values, const Setting& row, const std::vector<std::string>& texts) {
    if (texts.empty()) return {};
    return std::visit(Assign{values, row, texts}, row.field);
}

Status assign(Settings& values, std::string_view key, const std::vector<std::string>& texts) {
    std::vector<std::string> keys;
    for (const Setting& row : tables::settings) {
        if (row.key == key) return assign(values, row, texts);
        keys.emplace_back(row.key);
    }
    return fail({.code = ErrorCode::usage,
                 .where = std::string(key),
                 .what = "no such setting",
                 .found = std::string(key),
                 .remedy = base::suggestion(key, keys)});
}

std::vector<std::string> texts_of(const Settings& values, const Setting& row) {
    static const Settings initial;
    return std::visit(
        [&](auto field) -> std::vector<std::string> {
            if (values.*field == initial.*field) return {};
            return Texts{}(values.*field);
        },
        row.field);
}

std::vector<std::string> command_words(std::string_view command, const std::string& scene,
                                       const Settings& values, const std::string& output) {
    std::vector<std::string> words = {std::string(command), scene};
    if (!output.empty()) words.insert(words.end(), {"-o", output});
    for (const Setting& row : tables::settings) {
        std::vector<std::string> texts = texts_of(values, row);
        if (texts.empty()) continue;
        const bool is_list = std::holds_alternative<List Settings::*>(row.field);
        if (is_list && !row.repeatable) texts = {base::join(texts, ",")};
        for (const std::string& text : texts) {
            words.push_back(flag_name(row.key));
            if (!std::holds_alternative<Flag Settings::*>(row.field)) words.push_back(text);
        }
    }
    return words;
}

std::string command_line(const std::vector<std::string>& words) {
    std::string out = "facet";
    for (const std::string& word : words) out += " " + quoted(word);
    return out;
}

}  // namespace facet::tables
