// Reads a JSON object member by member.
// SPDX-License-Identifier: MIT
#include "teach/fields.h"

#include "base/text.h"
#include "base/texts.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::teach {
namespace {

std::string brief(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

const std::string& Localized::in(std::string_view language) const {
    static const std::string none;
    for (const std::string_view key : {language, std::string_view(), base::languages[0]})
        if (const auto found = texts.find(key); found != texts.end()) return found->second;
    return none;
}

bool Localized::is_complete() const {
    if (texts.contains("")) return true;
    return std::ranges::all_of(base::languages,
                               [&](std::string_view language) { return texts.contains(language); });
}

Fields::Fields(const Json& json, std::string pointer) : json_(json), pointer_(std::move(pointer)) {
    if (!json_.is_object()) refuse("", "not an object", brief(json_));
}

std::string Fields::pointer_to(std::string_view key) const {
    return key.empty() ? pointer_ : fmt::format("{}/{}", pointer_, key);
}

void Fields::refuse(std::string_view key, std::string what, std::string found, std::string remedy) {
    if (error_) return;
    error_ = base::Error{.code = base::ErrorCode::input_invalid,
                         .where = pointer_to(key),
                         .what = std::move(what),
                         .found = std::move(found),
                         .remedy = std::move(remedy)};
}

void Fields::keep(const base::Error& error, std::string_view key) {
    if (error_) return;
    error_ = error;
    error_->code = base::ErrorCode::input_invalid;
    if (!error_->where.starts_with('/')) error_->where = pointer_to(key);
}

bool Fields::is_known(std::string_view key) const {
    return std::ranges::find(known_, key) != known_.end();
}

const Json* Fields::find(std::string_view key) {
    known_.emplace_back(key);
    if (!json_.is_object()) return nullptr;
    const auto found = json_.find(std::string(key));
    return found == json_.end() ? nullptr : &*found;
}

const Json& Fields::object(std::string_view key) {
    static const Json none = Json::object();
    const Json* found = find(key);
    if (found == nullptr) return none;
    if (found->is_object()) return *found;
    refuse(key, "not an object", brief(*found));
    return none;
}

const Json& Fields::array(std::string_view key) {
    static const Json none = Json::array();
    const Json* found = find(key);
    if (found == nullptr) return none;
    if (found->is_array()) return *found;
    refuse(key, "not an array", brief(*found));
    return none;
}

double Fields::number(std::string_view key, double otherwise, tables::Range range) {
    const Json* found = find(key);
    if (found == nullptr) return otherwise;
    const std::string span = fmt::format("{} to {}", range.low, range.high);
    if (!found->is_number()) {
        refuse(key, "not a number", brief(*found), span);
        return otherwise;
    }
    const double value = found->get<double>();
    if (value >= static_cast<double>(range.low) && value <= static_cast<double>(range.high))
        return value;
    refuse(key, "out of range", brief(*found), span);
    return otherwise;
}

bool Fields::flag(std::string_view key, bool otherwise) {
    const Json* found = find(key);
    if (found == nullptr) return otherwise;
    if (found->is_boolean()) return found->get<bool>();
    refuse(key, "not true or false", brief(*found));
    return otherwise;
}

std::string Fields::text(std::string_view key, std::string_view otherwise) {
    const Json* found = find(key);
    if (found == nullptr) return std::string(otherwise);
    if (found->is_string()) return found->get<std::string>();
    refuse(key, "not a text", brief(*found));
    return std::string(otherwise);
}

Localized Fields::label(std::string_view key) {
    const Json* found = find(key);
    Localized out;
    if (found == nullptr) return out;
    if (found->is_string()) {
        out.texts[""] = found->get<std::string>();
        return out;
    }
    if (found->is_object())
        for (const auto& [language, text] : found->items())
            if (text.is_string()) out.texts[language] = text.get<std::string>();
    if (!out.is_complete() || out.texts.size() != found->size())
        refuse(key, "not a text, or one for each language", brief(*found),
               R"({"en": "...", "ru": "..."})");
    return out;
}

std::vector<std::string> Fields::texts(std::string_view key) {
    std::vector<std::string> out;
    for (const Json& text : array(key)) {
        if (text.is_string())
            out.push_back(text.get<std::string>());
        else
            refuse(key, "not a text", brief(text));
    }
    return out;
}

base::Status Fields::finish() {
    if (json_.is_object())
        for (const auto& [key, value] : json_.items())
            if (!is_known(key)) refuse(key, "no such member", key, base::suggestion(key, known_));
    if (error_) return tl::unexpected(*error_);
    return {};
}

}  // namespace facet::teach
