// Unsaved work.
// SPDX-License-Identifier: MIT
#include "studio/recovery.h"

#include "base/file.h"
#include "base/text.h"
#include "tables/settings_text.h"

#include <nlohmann/json.hpp>
#include <signal.h>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <vector>

namespace facet::studio {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t most_bytes = std::size_t{16} << 20;
constexpr std::string_view prefix = "studio-";

tl::unexpected<base::Error> invalid(std::string where, std::string what, std::string found = {}) {
    return base::fail({.code = base::ErrorCode::input_invalid,
                       .where = std::move(where),
                       .what = std::move(what),
                       .found = std::move(found),
                       .remedy = "it was not written by this version of Facet"});
}

base::Status read_setting(const std::string& key, const Json& value, tables::Settings& settings) {
    std::vector<std::string> texts;
    if (!value.is_array()) return invalid("/settings/" + key, "not an array");
    for (const Json& text : value) {
        if (!text.is_string()) return invalid("/settings/" + key, "not a string");
        texts.push_back(text.get<std::string>());
    }
    return tables::assign(settings, key, texts).map_error([&](base::Error error) {
        error.code = base::ErrorCode::input_invalid;
        error.where = "/settings/" + key;
        return error;
    });
}

/// Whether the process that wrote the file still runs.
bool is_in_use(const fs::path& file) {
    const std::string stem = file.stem().string();
    const auto pid = base::parse_integer(std::string_view(stem).substr(prefix.size()));
    return pid && *pid > 0 && ::kill(static_cast<pid_t>(*pid), 0) == 0;
}

}  // namespace

std::string recovery_text(const Document& document) {
    Json settings = Json::object();
    for (const tables::Setting& row : tables::settings)
        if (const auto texts = tables::texts_of(document.settings, row); !texts.empty())
            settings[std::string(row.key)] = texts;
    const Json json = {{"facet", 1}, {"scene", document.scene}, {"settings", settings}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

base::Result<Document> parse_recovery(std::string_view text) {
    const Json json = Json::parse(text.begin(), text.end(), nullptr, false);
    if (!json.is_object()) return invalid("", "not a JSON object");
    if (!json.contains("facet") || json["facet"] != 1) return invalid("/facet", "is not 1");
    if (!json.contains("scene") || !json["scene"].is_string())
        return invalid("/scene", "not a string");
    Document document{.scene = json["scene"].get<std::string>(), .settings = {}};
    if (!json.contains("settings") || !json["settings"].is_object())
        return invalid("/settings", "not an object");
    for (const auto& [key, value] : json["settings"].items())
        if (auto read = read_setting(key, value, document.settings); !read)
            return tl::unexpected(read.error());
    return document;
}

Recovery::Recovery(fs::path folder) : folder_(std::move(folder)) {
    if (!folder_.empty()) own_ = folder_ / fmt::format("{}{}.json", prefix, ::getpid());
}

base::Status Recovery::keep(const Document& document) {
    if (own_.empty()) return {};
    std::error_code error;
    fs::create_directories(folder_, error);
    const std::string text = recovery_text(document);
    return base::write_file_atomically(own_, std::as_bytes(std::span(text.data(), text.size())));
}

void Recovery::drop() {
    std::error_code error;
    if (!own_.empty()) fs::remove(own_, error);
}

std::optional<Recovered> Recovery::find() const {
    if (folder_.empty()) return std::nullopt;
    std::error_code error;
    std::optional<Recovered> newest;
    fs::file_time_type newest_time{};
    for (fs::directory_iterator at(folder_, error), end; !error && at != end; at.increment(error)) {
        const fs::path& file = at->path();
        if (!file.filename().string().starts_with(prefix) || file.extension() != ".json" ||
            is_in_use(file))
            continue;
        const auto time = fs::last_write_time(file, error);
        const auto bytes = base::read_file(file, most_bytes);
        if (error || !bytes || (newest && time <= newest_time)) continue;
        auto document =
            parse_recovery({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
        if (!document) continue;
        newest = Recovered{file, std::move(*document)};
        newest_time = time;
    }
    return newest;
}

}  // namespace facet::studio
