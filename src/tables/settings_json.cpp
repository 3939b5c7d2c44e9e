// The settings of a picture as JSON has them.
// SPDX-License-Identifier: MIT
#include "tables/settings_json.h"

#include "tables/settings_text.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <optional>
#include <string>

namespace facet::tables {
namespace {

using Json = nlohmann::ordered_json;

/// A number, a text or a truth value as its text; none for what is neither.
std::optional<std::string> text_of(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
    if (value.is_number_integer()) return value.dump();
    if (value.is_number()) return fmt::format("{}", value.get<double>());
    return std::nullopt;
}

/// Numbers of a vector with `between` between them; none where something else is among them.
std::optional<std::string> joined(const Json& values, std::string_view between) {
    std::string out;
    for (const Json& value : values) {
        if (!value.is_number()) return std::nullopt;
        if (!out.empty()) out += between;
        out += *text_of(value);
    }
    return out;
}

/// Whether `key` is a setting that is on or off; an unknown key is for assign() to name.
bool is_flag(std::string_view key) {
    for (const Setting& row : tables::settings)
        if (row.key == key) return std::holds_alternative<Flag Settings::*>(row.field);
    return true;
}

tl::unexpected<base::Error> refuse(std::string_view key, std::string what, const Json& found) {
    return base::fail({.code = base::ErrorCode::usage,
                       .where = std::string(key),
                       .what = std::move(what),
                       .found = found.dump(-1, ' ', false, Json::error_handler_t::replace)});
}

base::Status assign_paths(Settings& values, const Json& paths) {
    for (const auto& [path, value] : paths.items()) {
        const auto text = value.is_array() ? joined(value, " ") : text_of(value);
        if (!text) return refuse("set", "takes a number, a text or a vector for " + path, value);
        std::erase_if(values.set,
                      [&](const std::string& old) { return old.starts_with(path + "="); });
        values.set.push_back(path + "=" + *text);
    }
    return {};
}

}  // namespace

base::Status assign_json(Settings& values, std::string_view key, const Json& value) {
    if (key == "set" && value.is_object()) return assign_paths(values, value);
    if (const auto text = text_of(value)) {
        if (value.is_boolean() && !is_flag(key)) return refuse(key, "is not true or false", value);
        return assign(values, key, {*text});
    }
    if (!value.is_array()) return refuse(key, "is no value of a setting", value);
    if (key == "size") {
        const auto size = joined(value, "x");
        return size ? assign(values, key, {*size}) : refuse(key, "takes [width, height]", value);
    }
    std::vector<std::string> texts;
    for (const Json& part : value) {
        const auto text = text_of(part);
        if (!text) return refuse(key, "takes a list of texts", value);
        texts.push_back(*text);
    }
    return assign(values, key, texts);
}

}  // namespace facet::tables
