// The colours and distances of the user interface.
// SPDX-License-Identifier: MIT
#include "studio/theme.h"

#include <imgui.h>

namespace facet::studio {
namespace {

ImVec4 gray(float level, float alpha = 1.0F) { return {level, level, level, alpha}; }

/// Grays without a tint, so that colours are judged against nothing; one accent.
void dark_colors(ImVec4* colors) {
    const ImVec4 accent(0.27F, 0.52F, 0.84F, 1.0F);
    colors[ImGuiCol_WindowBg] = gray(0.145F);
    colors[ImGuiCol_ChildBg] = gray(0.145F);
    colors[ImGuiCol_PopupBg] = gray(0.18F, 0.99F);
    colors[ImGuiCol_MenuBarBg] = gray(0.18F);
    colors[ImGuiCol_Border] = gray(0.28F);
    colors[ImGuiCol_Text] = gray(0.90F);
    colors[ImGuiCol_TextDisabled] = gray(0.58F);
    colors[ImGuiCol_FrameBg] = gray(0.23F);
    colors[ImGuiCol_FrameBgHovered] = gray(0.29F);
    colors[ImGuiCol_FrameBgActive] = gray(0.33F);
    colors[ImGuiCol_Header] = gray(0.26F);
    colors[ImGuiCol_HeaderHovered] = gray(0.32F);
    colors[ImGuiCol_Button] = gray(0.27F);
    colors[ImGuiCol_ButtonHovered] = gray(0.35F);
    colors[ImGuiCol_Tab] = gray(0.18F);
    colors[ImGuiCol_TabHovered] = gray(0.34F);
    colors[ImGuiCol_TabActive] = gray(0.28F);
    colors[ImGuiCol_ScrollbarBg] = gray(0.145F);
    colors[ImGuiCol_ScrollbarGrab] = gray(0.34F);
    colors[ImGuiCol_Separator] = gray(0.25F);
    colors[ImGuiCol_ButtonActive] = accent;
    colors[ImGuiCol_HeaderActive] = accent;
    colors[ImGuiCol_SliderGrab] = gray(0.62F);
    colors[ImGuiCol_SliderGrabActive] = accent;
    colors[ImGuiCol_CheckMark] = gray(0.92F);
    colors[ImGuiCol_SeparatorHovered] = accent;
    colors[ImGuiCol_SeparatorActive] = accent;
    colors[ImGuiCol_NavHighlight] = accent;
    colors[ImGuiCol_TitleBgActive] = gray(0.22F);
}

void light_colors(ImVec4* colors) {
    const ImVec4 accent(0.20F, 0.45F, 0.78F, 1.0F);
    colors[ImGuiCol_WindowBg] = gray(0.94F);
    colors[ImGuiCol_ChildBg] = gray(0.94F);
    colors[ImGuiCol_PopupBg] = gray(0.98F, 0.99F);
    colors[ImGuiCol_MenuBarBg] = gray(0.90F);
    colors[ImGuiCol_Border] = gray(0.74F);
    colors[ImGuiCol_Text] = gray(0.10F);
    colors[ImGuiCol_TextDisabled] = gray(0.42F);
    colors[ImGuiCol_FrameBg] = gray(1.0F);
    colors[ImGuiCol_FrameBgHovered] = gray(0.88F);
    colors[ImGuiCol_FrameBgActive] = gray(0.84F);
    colors[ImGuiCol_Header] = gray(0.84F);
    colors[ImGuiCol_HeaderHovered] = gray(0.79F);
    colors[ImGuiCol_Button] = gray(0.83F);
    colors[ImGuiCol_ButtonHovered] = gray(0.76F);
    colors[ImGuiCol_Tab] = gray(0.87F);
    colors[ImGuiCol_TabHovered] = gray(0.78F);
    colors[ImGuiCol_TabActive] = gray(0.98F);
    colors[ImGuiCol_ScrollbarBg] = gray(0.94F);
    colors[ImGuiCol_ScrollbarGrab] = gray(0.70F);
    colors[ImGuiCol_Separator] = gray(0.78F);
    colors[ImGuiCol_ButtonActive] = accent;
    colors[ImGuiCol_HeaderActive] = accent;
    colors[ImGuiCol_SliderGrab] = gray(0.52F);
    colors[ImGuiCol_SliderGrabActive] = accent;
    colors[ImGuiCol_CheckMark] = gray(0.15F);
    colors[ImGuiCol_SeparatorHovered] = accent;
    colors[ImGuiCol_SeparatorActive] = accent;
    colors[ImGuiCol_NavHighlight] = accent;
    colors[ImGuiCol_TitleBgActive] = gray(0.86F);
}

}  // namespace

void apply_theme(Theme theme, float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    if (theme == Theme::dark) {
        ImGui::StyleColorsDark(&style);
        dark_colors(style.Colors);
    } else {
        ImGui::StyleColorsLight(&style);
        light_colors(style.Colors);
    }
    style.WindowRounding = 0.0F;
    style.FrameRounding = 3.0F;
    style.GrabRounding = 3.0F;
    style.PopupRounding = 4.0F;
    style.WindowBorderSize = 0.0F;
    style.FramePadding = {7.0F, 4.0F};
    style.ItemSpacing = {8.0F, 5.0F};
    style.ItemInnerSpacing = {6.0F, 4.0F};
    style.WindowPadding = {10.0F, 8.0F};
    style.ScrollbarSize = 12.0F;
    style.GrabMinSize = 10.0F;
    style.ScaleAllSizes(scale);
}

}  // namespace facet::studio
