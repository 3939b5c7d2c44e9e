// The menu above, and the line of text below.
// SPDX-License-Identifier: MIT
#include "studio/menu.h"

#include <spdlog/fmt/fmt.h>

namespace facet::studio {
namespace {

void draw_edit(PanelTools& tools) {
    Editor& editor = tools.editor;
    if (menu_item(tools.ui, "undo", "Ctrl+Z", false, editor.history.can_undo()))
        editor.history.undo(editor.document.settings);
    if (menu_item(tools.ui, "redo", "Ctrl+Y", false, editor.history.can_redo()))
        editor.history.redo(editor.document.settings);
}

}  // namespace

void draw_menu(PanelTools& tools) {
    if (!ImGui::BeginMainMenuBar()) return;
    const bool edits = ImGui::BeginMenu(labelled(tools.ui, "studio.edit").c_str());
    tools.ui.mark("edit");
    if (edits) {
        draw_edit(tools);
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
}

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
    const math::Extent size = tools.stage.size_px();
    ImGui::TextUnformatted(fmt::format("{} x {}  ·  {} / {}  ·  {:.0f} ms", size.width, size.height,
                                       tools.stage.samples(), tools.stage.samples_wanted(),
                                       tools.stage.last_ms())
                               .c_str());
    ImGui::End();
}

}  // namespace facet::studio
