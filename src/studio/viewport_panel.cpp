// The viewport.
// SPDX-License-Identifier: MIT
#include "studio/viewport_panel.h"

#include "render/job.h"
#include "studio/gizmo.h"
#include "studio/orbit.h"
#include "studio/widgets.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace facet::studio {
namespace {

/// A click that moved less than this is a click.
constexpr float click_px = 4.0F;

struct Area {
    math::Vec2 low_px;
    math::Vec2 size_px;
};

std::string view_label(const Ui& ui, const std::string& key) {
    return std::string(ui.t.or_else("view." + key, key));
}

void draw_bar(PanelTools& tools) {
    Ui& ui = tools.ui;
    Look& look = tools.editor.look;
    std::vector<std::string> names;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < views().size(); ++i) {
        names.push_back(view_label(ui, views()[i].key));
        if (views()[i].key == look.view) chosen = i;
    }
    ImGui::SetNextItemWidth(ui.px(150.0F));
    if (begin_combo(ui, "view", names[chosen].c_str())) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (ImGui::Selectable((names[i] + "###" + views()[i].key).c_str(), i == chosen))
                look.view = views()[i].key;
            ui.mark("view." + views()[i].key);
        }
        ImGui::EndCombo();
    }
    tooltip(ui.t("studio.view.help"));
    constexpr std::array beside_names = {"beside.nothing", "beside.original", "beside.reference",
                                         "beside.difference"};
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ui.px(150.0F));
    const auto now = static_cast<std::size_t>(look.beside);
    if (begin_combo(ui, "beside", ui.t(std::string("studio.") + beside_names[now]))) {
        for (std::size_t i = 0; i < beside_names.size(); ++i) {
            const std::string key = std::string("studio.") + beside_names[i];
            if (ImGui::Selectable(labelled(ui, key).c_str(), i == now))
                look.beside = static_cast<Beside>(i);
            ui.mark(beside_names[i]);
        }
        ImGui::EndCombo();
    }
    tooltip(ui.t("studio.beside.help"));
    ImGui::SameLine();
    ImGui::Checkbox(labelled(ui, "studio.clipping").c_str(), &look.clipping);
    ui.mark("clipping");
    tooltip(ui.t("studio.clipping.help"));
}

Slot beside_slot(Beside beside) {
    return beside == Beside::original    ? Slot::original
           : beside == Beside::reference ? Slot::reference
                                         : Slot::difference;
}

/// The picture, and right of the wipe what is beside it.
void draw_pictures(PanelTools& tools, const Area& area) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Look& look = tools.editor.look;
    // The finished picture lies on the GL with its rows from the bottom; others come from the top.
    const bool from_bottom = view_by_key(look.view).aovs.empty();
    const float top = from_bottom ? 1.0F : 0.0F;
    const bool split =
        look.beside != Beside::nothing && tools.ui.pictures.has(beside_slot(look.beside));
    const float wipe = split ? look.wipe : 1.0F;
    const ImVec2 low(area.low_px.x, area.low_px.y);
    const float middle = std::round(low.x + area.size_px.x * wipe);
    const float right = low.x + area.size_px.x;
    const float bottom = low.y + area.size_px.y;
    const float share = (middle - low.x) / area.size_px.x;
    if (middle > low.x)
        list.AddImage(texture_id(Slot::viewport), low, {middle, bottom}, {0.0F, top},
                      {share, 1.0F - top});
    if (!split) return;
    if (right > middle)
        list.AddImage(texture_id(beside_slot(look.beside)), {middle, low.y}, {right, bottom},
                      {share, 0.0F}, {1.0F, 1.0F});
    list.AddLine({middle, low.y}, {middle, bottom}, IM_COL32(255, 255, 255, 200),
                 tools.ui.px(1.5F));
}

/// The output's edges, where the viewport is wider.
void draw_output_frame(PanelTools& tools, const Area& area) {
    const math::Extent size = tools.editor.document.settings.size;
    const float width = area.size_px.y * static_cast<float>(size.width) /
                        static_cast<float>(std::max(1U, size.height));
    if (!tools.editor.look.frame || width >= area.size_px.x) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float left = area.low_px.x + 0.5F * (area.size_px.x - width);
    const ImU32 color = IM_COL32(255, 255, 255, 70);
    const float bottom = area.low_px.y + area.size_px.y;
    for (const float x : {left, left + width}) list.AddLine({x, area.low_px.y}, {x, bottom}, color);
}

/// The handle of the wipe. True while it is held.
bool drag_wipe(PanelTools& tools, const Area& area) {
    Look& look = tools.editor.look;
    if (look.beside == Beside::nothing) return false;
    const float half = tools.ui.px(5.0F);
    const float x = area.low_px.x + look.wipe * area.size_px.x;
    ImGui::SetCursorScreenPos({x - half, area.low_px.y});
    ImGui::InvisibleButton("wipe", {2.0F * half, area.size_px.y});
    tools.ui.mark("wipe");
    if (ImGui::IsItemHovered() || ImGui::IsItemActive())
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (!ImGui::IsItemActive()) return false;
    look.wipe =
        std::clamp((ImGui::GetIO().MousePos.x - area.low_px.x) / area.size_px.x, 0.0F, 1.0F);
    return true;
}

/// WASD and QE while the right button is held, a quarter of the distance a second.
math::Vec3 flight(const Orbit& orbit) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto axis = [&](int forth, int back) {
        return static_cast<float>(io.KeysDown[forth]) - static_cast<float>(io.KeysDown[back]);
    };
    const math::Vec3 way(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                         axis(GLFW_KEY_W, GLFW_KEY_S));
    return way * (0.6F * orbit.distance_m * io.DeltaTime * (io.KeyShift ? 4.0F : 1.0F));
}

bool move_view(Orbit& orbit, const PanelTools& tools, float height_px, bool hovered, bool active) {
    const ImGuiIO& io = ImGui::GetIO();
    const math::Vec2 by(io.MouseDelta.x, io.MouseDelta.y);
    const float fov = tools.stage.job().camera.yfov_rad;
    bool moved = false;
    if (hovered && io.MouseWheel != 0.0F) {
        zoom(orbit, io.MouseWheel);
        moved = true;
    }
    if (!active) return moved;
    if (io.MouseDown[ImGuiMouseButton_Right])
        if (const math::Vec3 way = flight(orbit); way != math::Vec3(0.0F)) {
            fly(orbit, way);
            moved = true;
        }
    if (by == math::Vec2(0.0F)) return moved;
    const bool pans = io.MouseDown[ImGuiMouseButton_Right] || io.KeyShift;
    if (pans)
        pan(orbit, by, height_px, fov);
    else if (io.KeyCtrl)
        zoom(orbit, -by.y * 0.05F);
    else
        turn(orbit, by);
    return true;
}

/// Alt and a drag turn the environment. True while they do.
bool turn_environment(PanelTools& tools, bool active) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!active || !io.KeyAlt) return false;
    constexpr float degrees_per_px = 0.5F;
    const float turned =
        tools.editor.document.settings.env_rotation + io.MouseDelta.x * degrees_per_px;
    if (io.MouseDelta.x != 0.0F)
        tools.editor.edit("env_rotation", [&](tables::Settings& settings) {
            settings.env_rotation = std::remainder(turned, 360.0F);
        });
    return true;
}

/// Orbit, pan, zoom and fly as in Blender and in model viewers.
void navigate(PanelTools& tools, const Area& area) {
    ImGui::SetCursorScreenPos({area.low_px.x, area.low_px.y});
    ImGui::InvisibleButton("viewport", {area.size_px.x, area.size_px.y},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    tools.ui.mark("viewport");
    ImGui::SetItemAllowOverlap();
    const bool hovered = ImGui::IsItemHovered();
    const bool active = ImGui::IsItemActive();
    const ImGuiIO& io = ImGui::GetIO();
    const math::Vec2 at(io.MousePos.x - area.low_px.x, io.MousePos.y - area.low_px.y);
    const bool clicked = ImGui::IsItemDeactivated() &&
                         ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
                         io.MouseDragMaxDistanceSqr[0] < click_px * click_px;
    const math::Extent drawn = tools.stage.size_px();
    const math::Vec2 to_picture(static_cast<float>(drawn.width) / area.size_px.x,
                                static_cast<float>(drawn.height) / area.size_px.y);
    if (hovered) tools.editor.wanted.probe_px = at * to_picture;
    if (clicked) tools.editor.wanted.pick_px = at * to_picture;
    if (turn_environment(tools, active)) return;
    Orbit orbit = orbit_of(tools.stage.job().camera, tools.stage.scene().bounds_m());
    const auto& held = tools.editor.orbit;
    if (held && camera_text(*held) == tools.editor.document.settings.camera) orbit = *held;
    if (!move_view(orbit, tools, area.size_px.y, hovered, active)) return;
    tools.editor.look_from(orbit, tools.stage.job().camera.yfov_rad);
}

}  // namespace

math::Extent draw_viewport(PanelTools& tools) {
    draw_bar(tools);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const Area area{{std::floor(low.x), std::floor(low.y)},
                    {std::floor(std::max(room.x, 16.0F)), std::floor(std::max(room.y, 16.0F))}};
    if (tools.ui.pictures.has(Slot::viewport)) {
        draw_pictures(tools, area);
        if (tools.editor.look.clipping && tools.ui.pictures.has(Slot::overlay))
            ImGui::GetWindowDrawList()->AddImage(
                texture_id(Slot::overlay), {area.low_px.x, area.low_px.y},
                {area.low_px.x + area.size_px.x, area.low_px.y + area.size_px.y});
        draw_output_frame(tools, area);
    }
    const bool held = drag_wipe(tools, area) || drag_gizmo(tools, area.low_px, area.size_px);
    if (!held) navigate(tools, area);
    return {static_cast<std::uint32_t>(area.size_px.x), static_cast<std::uint32_t>(area.size_px.y)};
}

}  // namespace facet::studio
