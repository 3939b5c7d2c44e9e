// What is being edited and looked at.
// SPDX-License-Identifier: MIT
#include "studio/editor.h"

#include "scene/camera_spec.h"

#include <cmath>

namespace facet::studio {
namespace {

constexpr std::size_t most_messages = 200;

}  // namespace

void Editor::edit(const std::string& name, const std::function<void(tables::Settings&)>& change) {
    const tables::Settings before = document.settings;
    change(document.settings);
    if (document.settings == before) return;
    history.record(name, before);
    unsaved = true;
}

void Editor::set(const std::string& path, const std::string& value) {
    edit(path, [&](tables::Settings& settings) { set_path(settings, path, value); });
}

void Editor::clear(const std::string& path) {
    history.seal();
    edit("-" + path, [&](tables::Settings& settings) { clear_path(settings, path); });
    history.seal();
}

void Editor::paste_material(std::size_t index) {
    if (copied_material.empty()) return;
    history.seal();
    edit("paste", [&](tables::Settings& settings) {
        for (const auto& [key, value] : copied_material)
            set_path(settings, material_path(index, key), value);
    });
}

void Editor::look_from(const Orbit& from, float fov_rad) {
    tables::Settings& settings = document.settings;
    if (settings.fov == 0.0F && !scene::is_orbit(settings.camera))
        settings.fov = fov_rad * 180.0F / math::pi;
    orbit = from;
    settings.camera = camera_text(from);
}

void Editor::play(float passed_s, float end_s) {
    const float now_s = document.settings.time.value_or(0.0F) + passed_s;
    document.settings.time = end_s > 0.0F ? std::fmod(now_s, end_s) : 0.0F;
}

void Editor::say(Message::Kind kind, std::string text) {
    if (!messages.empty() && messages.back().text == text) return;
    messages.push_back({kind, std::move(text)});
    if (messages.size() > most_messages) messages.erase(messages.begin());
}

}  // namespace facet::studio
