// What panels are drawn with.
// SPDX-License-Identifier: MIT
#include "studio/ui.h"

namespace facet::studio {

void Ui::mark(std::string_view name) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    widgets.insert_or_assign(std::string(name), Widget{{low.x, low.y}, {high.x, high.y}, {}});
}

void Ui::mark_slider(std::string_view name, float low, float high, bool logarithmic) {
    mark(name);
    Widget& widget = widgets.find(name)->second;
    widget.range = {low, high};
    widget.logarithmic = logarithmic;
}

std::string labelled(const Ui& ui, std::string_view key) {
    return std::string(ui.t(key)) + "###" + std::string(key);
}

namespace {

std::string studio_label(const Ui& ui, std::string_view name) {
    return labelled(ui, "studio." + std::string(name));
}

}  // namespace

bool begin_combo(Ui& ui, const std::string& name, const char* shown) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const math::Vec2 corner(low.x, low.y);
    const math::Vec2 size(ImGui::CalcItemWidth(), ImGui::GetFrameHeight());
    ui.widgets.insert_or_assign(name, Widget{corner, corner + size, {}});
    return ImGui::BeginCombo(("##" + name).c_str(), shown, ImGuiComboFlags_HeightLarge);
}

bool button(Ui& ui, std::string_view name) {
    const bool pressed = ImGui::Button(studio_label(ui, name).c_str());
    ui.mark(name);
    return pressed;
}

bool small_button(Ui& ui, std::string_view name) {
    const bool pressed = ImGui::SmallButton(studio_label(ui, name).c_str());
    ui.mark(name);
    return pressed;
}

bool menu_item(Ui& ui, std::string_view name, const char* keys, bool selected, bool enabled) {
    const bool pressed = ImGui::MenuItem(studio_label(ui, name).c_str(), keys, selected, enabled);
    ui.mark(name);
    return pressed;
}

void tooltip(std::string_view text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28.0F);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void heading(const char* text) {
    ImGui::Dummy({0.0F, ImGui::GetStyle().ItemSpacing.y * 0.5F});
    ImGui::TextDisabled("%s", text);
    ImGui::Separator();
}

void row_label(Ui& ui, std::string_view text, std::string_view help) {
    const float left = ImGui::GetCursorPosX();
    const float column = std::min(ui.px(120.0F), ImGui::GetContentRegionAvail().x * 0.42F);
    ImGui::AlignTextToFramePadding();
    ImGui::PushClipRect(ImGui::GetCursorScreenPos(),
                        {ImGui::GetCursorScreenPos().x + column - ui.px(4.0F),
                         ImGui::GetCursorScreenPos().y + ImGui::GetFrameHeight()},
                        true);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopClipRect();
    tooltip(help);
    ImGui::SameLine(left + column);
}

void picture(Slot slot, math::Vec2 size_px, math::Vec2 uv_low, math::Vec2 uv_high) {
    ImGui::Image(texture_id(slot), {size_px.x, size_px.y}, {uv_low.x, uv_low.y},
                 {uv_high.x, uv_high.y});
}

}  // namespace facet::studio
