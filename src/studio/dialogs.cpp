// What the menus do: the dialogs besides that for files.
// SPDX-License-Identifier: MIT
#include "studio/commands.h"

#include <spdlog/fmt/fmt.h>

#include <array>

namespace facet::studio {
namespace {

/// A window in the middle that takes the attention.
bool begin_dialog(const char* title) {
    ImGui::OpenPopup(title);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x * 0.5F, window.y * 0.5F}, ImGuiCond_Always, {0.5F, 0.5F});
    return ImGui::BeginPopupModal(title, nullptr,
                                  ImGuiWindowFlags_AlwaysAutoResize |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove);
}

}  // namespace

void Commands::draw_recovered() {
    if (!recovered_) return;
    Ui& ui = tools_.ui;
    if (!begin_dialog(labelled(ui, "studio.recovered").c_str())) return;
    ImGui::TextUnformatted(ui.t("studio.recovered.text"));
    ImGui::TextDisabled("%s", recovered_->document.scene.c_str());
    const bool restore = button(ui, "restore");
    ImGui::SameLine();
    const bool forget = button(ui, "forget");
    ImGui::SameLine();
    const bool later = button(ui, "later");
    if (restore || forget || later) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (!restore && !forget && !later) return;
    const Recovered recovered = *std::exchange(recovered_, std::nullopt);
    std::error_code error;
    if (restore) {
        // Opened as it was, then edited: the work can be undone to the scene as it is.
        Document document = recovered.document;
        if (auto s = open_scene(document); !s) return tools_.editor.complain(s.error());
        tools_.editor.unsaved = true;
        tools_.editor.opened.set.clear();
        tools_.editor.opened.light.clear();
        keep_work();
    }
    if (!later) std::filesystem::remove(recovered.file, error);
}

void Commands::draw_closing() {
    if (closing_ != Closing::asked) return;
    Ui& ui = tools_.ui;
    if (!begin_dialog(labelled(ui, "studio.unsaved").c_str())) return;
    ImGui::TextUnformatted(ui.t("studio.unsaved.text"));
    const bool save = button(ui, "save");
    ImGui::SameLine();
    const bool discard = button(ui, "discard");
    ImGui::SameLine();
    const bool cancel =
        button(ui, "cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (save || discard || cancel) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (save || cancel) closing_ = Closing::no;
    if (save) act(Action::save);
    if (discard) {
        closing_ = Closing::yes;
        tools_.editor.wanted.quit = true;
    }
}

void Commands::draw_keys() {
    if (!shows_keys_) return;
    Ui& ui = tools_.ui;
    if (!begin_dialog(labelled(ui, "studio.keys").c_str())) return;
    if (ImGui::BeginTable("keys", 2)) {
        for (const ActionRow& row : actions) {
            if (row.keys.empty()) continue;
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(ui.t("studio." + std::string(row.name)));
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", shown_keys(row.keys).c_str());
        }
        ImGui::EndTable();
    }
    ImGui::Separator();
    ImGui::TextUnformatted(ui.t("studio.mouse_help"));
    if (button(ui, "close") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        shows_keys_ = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

void Commands::draw() {
    draw_recovered();
    draw_closing();
    draw_keys();
}

}  // namespace facet::studio
