// What the studio remembers between sessions.
// SPDX-License-Identifier: MIT
#include "studio/config.h"

#include "base/file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>

namespace facet::studio {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_bytes = std::size_t{1} << 20;
constexpr std::size_t most_recent = 10;

std::filesystem::path folder_of(const char* variable, const char* below_home) {
    const char* value = std::getenv(variable);
    if (value != nullptr && std::filesystem::path(value).is_absolute())
        return std::filesystem::path(value) / "facet";
    const char* home = std::getenv("HOME");
    if (home == nullptr || !std::filesystem::path(home).is_absolute()) return {};
    return std::filesystem::path(home) / below_home / "facet";
}

float number_or(const Json& json, const char* key, float otherwise) {
    const auto found = json.find(key);
    return found != json.end() && found->is_number() ? found->get<float>() : otherwise;
}

std::string text_or(const Json& json, const char* key, const std::string& otherwise) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

std::uint32_t side_or(const Json& json, const char* key, std::uint32_t otherwise) {
    const float side = number_or(json, key, static_cast<float>(otherwise));
    return side >= 320.0F && side <= 8192.0F ? static_cast<std::uint32_t>(side) : otherwise;
}

}  // namespace

std::filesystem::path config_folder() { return folder_of("XDG_CONFIG_HOME", ".config"); }
std::filesystem::path state_folder() { return folder_of("XDG_STATE_HOME", ".local/state"); }

void Config::remember(const std::string& scene) {
    std::erase(recent, scene);
    recent.insert(recent.begin(), scene);
    if (recent.size() > most_recent) recent.resize(most_recent);
}

Config load_config() {
    Config config;
    const auto text = base::read_text_file(config_folder() / "studio.json", most_bytes);
    if (!text) return config;
    const Json json = Json::parse(*text, nullptr, false);
    if (!json.is_object()) return config;
    config.theme = text_or(json, "theme", "dark") == "light" ? Theme::light : Theme::dark;
    config.language = text_or(json, "language", "");
    if (config.language != "ru" && config.language != "en") config.language.clear();
    config.window_points = {side_or(json, "width", config.window_points.width),
                            side_or(json, "height", config.window_points.height)};
    config.layout = {number_or(json, "left", config.layout.left),
                     number_or(json, "right", config.layout.right),
                     number_or(json, "bottom", config.layout.bottom)};
    if (const auto recent = json.find("recent"); recent != json.end() && recent->is_array())
        for (const Json& scene : *recent)
            if (scene.is_string() && config.recent.size() < most_recent)
                config.recent.push_back(scene.get<std::string>());
    return config;
}

void save_config(const Config& config) {
    const auto folder = config_folder();
    if (folder.empty()) return;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const Json json = {{"facet", 1},
                       {"theme", config.theme == Theme::light ? "light" : "dark"},
                       {"language", config.language},
                       {"width", config.window_points.width},
                       {"height", config.window_points.height},
                       {"left", config.layout.left},
                       {"right", config.layout.right},
                       {"bottom", config.layout.bottom},
                       {"recent", config.recent}};
    const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    (void)base::write_file_atomically(folder / "studio.json",
                                      std::as_bytes(std::span(text.data(), text.size())));
}

std::string desktop_language() {
    for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"})
        if (const char* value = std::getenv(variable); value != nullptr && *value != '\0')
            return std::string_view(value).starts_with("ru") ? "ru" : "en";
    return "en";
}

}  // namespace facet::studio
