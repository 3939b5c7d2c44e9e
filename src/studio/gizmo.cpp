// Handles in the viewport for the selected light.
// SPDX-License-Identifier: MIT
#include "studio/gizmo.h"

#include "base/text.h"
#include "render/job.h"
#include "scene/camera_spec.h"
#include "scene/light_spec.h"
#include "tables/lights.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace facet::studio {
namespace {

constexpr float arrow_px = 70.0F;
constexpr float sun_degrees_per_px = 0.5F;

/// From the world to the viewport, for this frame.
struct Projector {
    math::Mat4 clip_from_world;
    math::Vec2 low_px;
    math::Vec2 size_px;

    [[nodiscard]] std::optional<math::Vec2> operator()(const math::Vec3& at_m) const {
        const math::Vec4 clip = clip_from_world * math::Vec4(at_m, 1.0F);
        if (clip.w <= 1e-6F) return std::nullopt;
        const math::Vec2 ndc(clip.x / clip.w, -clip.y / clip.w);
        return low_px + (ndc * 0.5F + 0.5F) * size_px;
    }
};

Projector projector(const PanelTools& tools, math::Vec2 low_px, math::Vec2 size_px) {
    const scene::Camera& camera = tools.stage.job().camera;
    const math::Extent size{static_cast<std::uint32_t>(size_px.x),
                            static_cast<std::uint32_t>(size_px.y)};
    return {scene::clip_from_view(camera, size, math::Vec2(0.0F)) * scene::view_from_world(camera),
            low_px, size_px};
}

ImVec2 im(math::Vec2 v) { return {v.x, v.y}; }

bool has_key(const scene::Light& light, std::string_view key) {
    const auto keys =
        base::split(tables::light_kinds[static_cast<std::size_t>(light.kind)].keys, ',');
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// A button over the viewport, `half` around `at_px`.
bool handle(PanelTools& tools, const std::string& name, math::Vec2 at_px, float half) {
    ImGui::SetCursorScreenPos({at_px.x - half, at_px.y - half});
    ImGui::InvisibleButton(name.c_str(), {2.0F * half, 2.0F * half});
    tools.ui.mark(name);
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return ImGui::IsItemActive();
}

void draw_lights(PanelTools& tools, const Projector& to_px) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto& lights = tools.stage.lights();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (lights[i].kind == tables::LightKind::directional) continue;
        const auto at = to_px(lights[i].position_m);
        if (!at) continue;
        const bool chosen = tools.editor.light == i;
        list.AddCircleFilled(im(*at), tools.ui.px(chosen ? 6.0F : 4.0F),
                             IM_COL32(255, 220, 120, chosen ? 255 : 170));
        list.AddCircle(im(*at), tools.ui.px(chosen ? 6.0F : 4.0F), IM_COL32(0, 0, 0, 180));
    }
}

/// Arrows along x, y and z that move the light.
bool move_light(PanelTools& tools, const Projector& to_px, std::size_t index) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const scene::Light& light = tools.stage.lights()[index];
    const auto origin = to_px(light.position_m);
    if (!origin) return false;
    constexpr std::array colors = {IM_COL32(235, 80, 80, 255), IM_COL32(110, 205, 90, 255),
                                   IM_COL32(90, 140, 245, 255)};
    const float step_m = 1e-2F * std::max(tools.stage.scene().bounds_m().diagonal(), 1e-3F);
    bool held = false;
    for (int axis = 0; axis < 3; ++axis) {
        math::Vec3 along(0.0F);
        along[axis] = step_m;
        const auto end = to_px(light.position_m + along);
        if (!end) continue;
        const math::Vec2 per_step = *end - *origin;
        const float length = math::length(per_step);
        if (length < 0.02F) continue;  // seen from its end
        const math::Vec2 tip = *origin + per_step * (tools.ui.px(arrow_px) / length);
        const auto color = colors[static_cast<std::size_t>(axis)];
        list.AddLine(im(*origin), im(tip), color, tools.ui.px(2.5F));
        list.AddCircleFilled(im(tip), tools.ui.px(5.0F), color);
        if (!handle(tools, fmt::format("gizmo.{}", "xyz"[axis]), tip, tools.ui.px(9.0F))) continue;
        held = true;
        const ImVec2 by = ImGui::GetIO().MouseDelta;
        const float steps = (by.x * per_step.x + by.y * per_step.y) / (length * length);
        if (steps != 0.0F)
            tools.editor.set(light_path(index, "position"),
                             vector_text(light.position_m + along * steps));
    }
    return held;
}

/// A sun: a disk whose drag turns where the light comes from.
bool turn_light(PanelTools& tools, const Projector& to_px, std::size_t index) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const scene::Light& light = tools.stage.lights()[index];
    const math::Bounds bounds = tools.stage.scene().bounds_m();
    const auto center = to_px(bounds.center());
    const auto sun = to_px(bounds.center() - light.direction * (0.6F * bounds.diagonal()));
    if (!center || !sun) return false;
    list.AddLine(im(*sun), im(*center), IM_COL32(255, 220, 120, 120), tools.ui.px(1.5F));
    list.AddCircleFilled(im(*sun), tools.ui.px(8.0F), IM_COL32(255, 220, 120, 255));
    list.AddCircle(im(*sun), tools.ui.px(8.0F), IM_COL32(0, 0, 0, 180));
    if (!handle(tools, "gizmo.sun", *sun, tools.ui.px(11.0F))) return false;
    const ImVec2 by = ImGui::GetIO().MouseDelta;
    if (by.x == 0.0F && by.y == 0.0F) return true;
    const scene::SkyAngles from = scene::sky_angles(light);
    const float turned = std::remainder(from.azimuth_deg + by.x * sun_degrees_per_px, 360.0F);
    const float raised = std::clamp(from.elevation_deg - by.y * sun_degrees_per_px, -90.0F, 90.0F);
    tools.editor.edit(light_path(index, "sun"), [&](tables::Settings& settings) {
        set_path(settings, light_path(index, "azimuth"), number_text(turned));
        set_path(settings, light_path(index, "elevation"), number_text(raised));
    });
    return true;
}

}  // namespace

bool drag_gizmo(PanelTools& tools, math::Vec2 low_px, math::Vec2 size_px) {
    const auto& lights = tools.stage.lights();
    const Projector to_px = projector(tools, low_px, size_px);
    ImGui::PushClipRect(im(low_px), im(low_px + size_px), true);
    draw_lights(tools, to_px);
    bool held = false;
    if (tools.editor.light && *tools.editor.light < lights.size()) {
        const scene::Light& light = lights[*tools.editor.light];
        held = has_key(light, "azimuth") && !has_key(light, "range")
                   ? turn_light(tools, to_px, *tools.editor.light)
                   : move_light(tools, to_px, *tools.editor.light);
    }
    ImGui::PopClipRect();
    return held;
}

}  // namespace facet::studio
