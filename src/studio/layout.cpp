// Where the panels are.
// SPDX-License-Identifier: MIT
#include "studio/layout.h"

#include "studio/inspector.h"
#include "studio/viewport_panel.h"

#include <algorithm>

namespace facet::studio {
namespace {

constexpr float splitter_points = 5.0F;
constexpr float least_points = 140.0F;
constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoTitleBar |
                                   ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoBringToFrontOnFocus;

void begin_panel(const char* name, ImVec2 low, ImVec2 high, ImGuiWindowFlags flags = 0) {
    ImGui::SetNextWindowPos(low);
    ImGui::SetNextWindowSize({std::max(high.x - low.x, 1.0F), std::max(high.y - low.y, 1.0F)});
    ImGui::Begin(name, nullptr, fixed | flags);
}

/// A bar between two panels; gives by how many points it was dragged.
float splitter(Ui& ui, const char* name, ImVec2 low, ImVec2 high) {
    const bool upright = high.y - low.y > high.x - low.x;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0F, 1.0F});
    begin_panel(name, low, high, ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar(2);
    ImGui::InvisibleButton(name, {high.x - low.x, high.y - low.y});
    ui.mark(name);
    const bool held = ImGui::IsItemActive();
    if (held || ImGui::IsItemHovered())
        ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const ImVec2 by = ImGui::GetIO().MouseDelta;
    ImGui::End();
    return held ? (upright ? by.x : by.y) / ui.scale : 0.0F;
}

/// Panels keep room for the viewport, however small the window is.
void hold(Layout& layout, math::Vec2 window_points) {
    const float widest = std::max(least_points, 0.5F * window_points.x - least_points);
    layout.left = std::clamp(layout.left, least_points, widest);
    layout.right = std::clamp(layout.right, least_points, widest);
    layout.bottom = std::clamp(layout.bottom, 40.0F, std::max(40.0F, 0.6F * window_points.y));
}

}  // namespace

math::Extent draw_panels(PanelTools& tools, Layout& layout) {
    Ui& ui = tools.ui;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    hold(layout, {window.x / ui.scale, window.y / ui.scale});
    const float top = ImGui::GetFrameHeight();
    const float end = window.y - ImGui::GetFrameHeight();
    const float gap = ui.px(splitter_points);
    const float left = ui.px(layout.left);
    const float right = window.x - ui.px(layout.right);
    const float low = end - ui.px(layout.bottom);

    begin_panel("scene", {0.0F, top}, {left, end});
    draw_scene_panel(tools);
    ImGui::End();
    begin_panel("material", {right, top}, {window.x, end});
    draw_material_panel(tools);
    ImGui::End();
    begin_panel("inspector", {left + gap, low + gap}, {right - gap, end});
    draw_inspector(tools);
    ImGui::End();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, ui.px(4.0F)});
    begin_panel("view", {left + gap, top}, {right - gap, low},
                ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                    ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    const math::Extent area = draw_viewport(tools);
    ImGui::End();

    layout.left += splitter(ui, "splitter.left", {left, top}, {left + gap, end});
    layout.right -= splitter(ui, "splitter.right", {right - gap, top}, {right, end});
    layout.bottom -= splitter(ui, "splitter.bottom", {left + gap, low}, {right - gap, low + gap});
    return area;
}

}  // namespace facet::studio
