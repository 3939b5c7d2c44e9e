// The menu above, and the line of text below.
// SPDX-License-Identifier: MIT
#include "studio/menu.h"

#include "studio/actions.h"

#include <spdlog/fmt/fmt.h>

#include <filesystem>

namespace facet::studio {
namespace {

bool is_enabled(const Editor& editor, Action action) {
    if (action == Action::undo) return editor.history.can_undo();
    if (action == Action::redo) return editor.history.can_redo();
    if (action == Action::paste) return !editor.copied_material.empty();
    return true;
}

bool is_on(const Look& look, Action action) {
    return (action == Action::beside_original && look.beside == Beside::original) ||
           (action == Action::beside_reference && look.beside == Beside::reference) ||
           (action == Action::beside_difference && look.beside == Beside::difference) ||
           (action == Action::toggle_solo && look.solo) ||
           (action == Action::toggle_clipping && look.clipping);
}

void draw_recent(PanelTools& tools, const std::vector<std::string>& recent) {
    if (!ImGui::BeginMenu(labelled(tools.ui, "studio.recent").c_str(), !recent.empty())) return;
    for (const std::string& scene : recent)
        if (ImGui::MenuItem(scene.c_str())) tools.editor.wanted.open = scene;
    ImGui::EndMenu();
}

}  // namespace

std::optional<Action> draw_menu(PanelTools& tools, const std::vector<std::string>& recent) {
    std::optional<Action> chosen = pressed_action();
    if (!ImGui::BeginMainMenuBar()) return chosen;
    for (const std::string_view menu : {"file", "edit", "view", "help"}) {
        const std::string key = "studio.menu." + std::string(menu);
        const bool is_open = ImGui::BeginMenu(labelled(tools.ui, key).c_str());
        tools.ui.mark("menu." + std::string(menu));
        if (!is_open) continue;
        for (std::size_t i = 0; i < actions.size(); ++i) {
            if (actions[i].menu != menu) continue;
            const auto action = static_cast<Action>(i);
            if (menu_item(tools.ui, actions[i].name, shown_keys(actions[i].keys).c_str(),
                          is_on(tools.editor.look, action), is_enabled(tools.editor, action)))
                chosen = action;
            if (action == Action::open) draw_recent(tools, recent);
        }
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
    return chosen;
}

namespace {

std::string stage_text(const PanelTools& tools) {
    const math::Extent size = tools.stage.size_px();
    const std::string text =
        fmt::format("{} x {}   {} {} / {}", size.width, size.height, tools.ui.t("studio.samples"),
                    tools.stage.samples(), tools.stage.samples_wanted());
    if (tools.stage.is_steady()) return text;  // whose pictures are the same on any machine
    return text + fmt::format("   {:.0f} ms", tools.stage.last_ms());
}

void draw_message(PanelTools& tools) {
    const auto& messages = tools.editor.messages;
    if (messages.empty()) return;
    const Message& last = messages.back();
    if (last.kind == Message::Kind::error)
        ImGui::TextColored({0.95F, 0.42F, 0.38F, 1.0F}, "%s", last.text.c_str());
    else if (last.kind == Message::Kind::warning)
        ImGui::TextColored({0.90F, 0.70F, 0.30F, 1.0F}, "%s", last.text.c_str());
    else
        ImGui::TextUnformatted(last.text.c_str());
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    const std::size_t first = messages.size() - std::min<std::size_t>(messages.size(), 20);
    for (std::size_t i = first; i < messages.size(); ++i)
        ImGui::TextUnformatted(messages[i].text.c_str());
    ImGui::EndTooltip();
}

}  // namespace

void draw_status(PanelTools& tools) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float height = ImGui::GetFrameHeight();
    ImGui::SetNextWindowPos({0.0F, window.y - height});
    ImGui::SetNextWindowSize({window.x, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {tools.ui.px(8.0F), tools.ui.px(3.0F)});
    ImGui::Begin(
        "status", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    const std::string scene =
        std::filesystem::path(tools.editor.document.scene).filename().string() +
        (tools.editor.unsaved ? " *" : "");
    ImGui::TextUnformatted(scene.c_str());
    const std::string text = stage_text(tools);
    ImGui::SameLine(0.0F, tools.ui.px(24.0F));
    const float right = window.x - ImGui::CalcTextSize(text.c_str()).x - tools.ui.px(24.0F);
    ImGui::PushClipRect({0.0F, window.y - height}, {right, window.y}, true);
    draw_message(tools);
    ImGui::PopClipRect();
    ImGui::SameLine(window.x - ImGui::CalcTextSize(text.c_str()).x - tools.ui.px(10.0F));
    ImGui::TextDisabled("%s", text.c_str());
    ImGui::End();
}

}  // namespace facet::studio
