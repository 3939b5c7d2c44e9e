// Everything the menus do, with its keys.
// SPDX-License-Identifier: MIT
#include "studio/actions.h"

#include "base/text.h"
#include "studio/input.h"

#include <imgui.h>

#include <cctype>

namespace facet::studio {
namespace {

bool is_pressed(std::string_view keys) {
    if (keys.empty()) return false;
    const ImGuiIO& io = ImGui::GetIO();
    bool ctrl = false;
    bool shift = false;
    int key = 0;
    for (const std::string_view part : base::split(keys, '+')) {
        ctrl = ctrl || part == "ctrl";
        shift = shift || part == "shift";
        key = key_by_name(part);
    }
    return io.KeyCtrl == ctrl && io.KeyShift == shift && !io.KeyAlt &&
           ImGui::IsKeyPressed(key, false);
}

}  // namespace

std::optional<Action> pressed_action() {
    const ImGuiIO& io = ImGui::GetIO();
    // Letters fly the camera while the right button is held.
    if (io.WantTextInput || io.MouseDown[ImGuiMouseButton_Right]) return std::nullopt;
    for (std::size_t i = 0; i < actions.size(); ++i)
        if (is_pressed(actions[i].keys)) return static_cast<Action>(i);
    return std::nullopt;
}

std::string shown_keys(std::string_view keys) {
    std::string out;
    bool first = true;
    for (const char c : keys) {
        out += first ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        first = c == '+';
    }
    return out;
}

}  // namespace facet::studio
