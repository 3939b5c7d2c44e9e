// What a person does with mouse and keyboard in one frame.
// SPDX-License-Identifier: MIT
#include "studio/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <string_view>
#include <utility>

namespace facet::studio {
namespace {

struct NamedKey {
    std::string_view name;
    int key;
};
constexpr NamedKey named_keys[] = {
    {"ctrl", GLFW_KEY_LEFT_CONTROL}, {"shift", GLFW_KEY_LEFT_SHIFT},    {"alt", GLFW_KEY_LEFT_ALT},
    {"escape", GLFW_KEY_ESCAPE},     {"enter", GLFW_KEY_ENTER},         {"tab", GLFW_KEY_TAB},
    {"space", GLFW_KEY_SPACE},       {"backspace", GLFW_KEY_BACKSPACE}, {"delete", GLFW_KEY_DELETE},
    {"left", GLFW_KEY_LEFT},         {"right", GLFW_KEY_RIGHT},         {"up", GLFW_KEY_UP},
    {"down", GLFW_KEY_DOWN},         {"home", GLFW_KEY_HOME},           {"end", GLFW_KEY_END},
    {"pageup", GLFW_KEY_PAGE_UP},    {"pagedown", GLFW_KEY_PAGE_DOWN}};

}  // namespace

int key_by_name(std::string_view name) {
    for (const NamedKey& row : named_keys)
        if (row.name == name) return row.key;
    if (name.size() == 1) {
        const char c = name[0];
        if (c >= 'a' && c <= 'z') return GLFW_KEY_A + (c - 'a');
        if (c >= '0' && c <= '9') return GLFW_KEY_0 + (c - '0');
    }
    if (name.size() >= 2 && name[0] == 'f') {
        int number = 0;
        for (const char c : name.substr(1))
            number = c >= '0' && c <= '9' ? number * 10 + c - '0' : 99;
        if (number >= 1 && number <= 12) return GLFW_KEY_F1 + number - 1;
    }
    return 0;
}

void map_keys() {
    ImGuiIO& io = ImGui::GetIO();
    const std::pair<ImGuiKey, int> pairs[] = {{ImGuiKey_Tab, GLFW_KEY_TAB},
                                              {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                              {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                                              {ImGuiKey_UpArrow, GLFW_KEY_UP},
                                              {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                              {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
                                              {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
                                              {ImGuiKey_Home, GLFW_KEY_HOME},
                                              {ImGuiKey_End, GLFW_KEY_END},
                                              {ImGuiKey_Insert, GLFW_KEY_INSERT},
                                              {ImGuiKey_Delete, GLFW_KEY_DELETE},
                                              {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
                                              {ImGuiKey_Space, GLFW_KEY_SPACE},
                                              {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                              {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
                                              {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
                                              {ImGuiKey_A, GLFW_KEY_A},
                                              {ImGuiKey_C, GLFW_KEY_C},
                                              {ImGuiKey_V, GLFW_KEY_V},
                                              {ImGuiKey_X, GLFW_KEY_X},
                                              {ImGuiKey_Y, GLFW_KEY_Y},
                                              {ImGuiKey_Z, GLFW_KEY_Z}};
    for (const auto& [key, number] : pairs) io.KeyMap[key] = number;
}

void MouseQueue::advance(Input& input, math::Vec2 now_px) {
    if (events_.empty()) {
        input.mouse_px = now_px;
        return;
    }
    const Event event = events_.front();
    const bool has_moved = input.mouse_px != event.at_px;
    input.mouse_px = event.at_px;
    // What is dragged follows while the button is held: it moves there before it is let go.
    if (!event.is_down && has_moved && input.buttons[event.button]) return;
    input.buttons[event.button] = event.is_down;
    events_.pop_front();
}

void feed_imgui(const Input& input, float delta_s) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(input.window_px.width),
                      static_cast<float>(input.window_px.height)};
    io.DeltaTime = delta_s;
    io.MousePos = {input.mouse_px.x, input.mouse_px.y};
    for (std::size_t i = 0; i < input.buttons.size(); ++i) io.MouseDown[i] = input.buttons[i];
    io.MouseWheel = input.wheel;
    const auto down = [&](int key) {
        const auto i = static_cast<std::size_t>(key);
        return input.keys[i] || input.typed_keys[i];
    };
    for (int key = 0; key < static_cast<int>(key_count); ++key) io.KeysDown[key] = down(key);
    io.KeyCtrl = down(GLFW_KEY_LEFT_CONTROL) || down(GLFW_KEY_RIGHT_CONTROL);
    io.KeyShift = down(GLFW_KEY_LEFT_SHIFT) || down(GLFW_KEY_RIGHT_SHIFT);
    io.KeyAlt = down(GLFW_KEY_LEFT_ALT) || down(GLFW_KEY_RIGHT_ALT);
    for (const char32_t c : input.text)
        if (c >= 0x20 && c <= 0xFFFF) io.AddInputCharacter(c);
}

}  // namespace facet::studio
