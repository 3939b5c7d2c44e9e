// The scene panel: what is in the scene, its lights, environment, camera and picture.
// SPDX-License-Identifier: MIT
#include "scene/light_shapes.h"
#include "studio/animation_rows.h"
#include "studio/light_rows.h"
#include "studio/panels.h"
#include "studio/settings_rows.h"

#include <spdlog/fmt/fmt.h>

namespace facet::studio {
namespace {

bool section(Ui& ui, std::string_view name) {
    const bool is_open = ImGui::CollapsingHeader(
        labelled(ui, "studio." + std::string(name)).c_str(), ImGuiTreeNodeFlags_DefaultOpen);
    ui.mark(name);
    return is_open;
}

/// The nodes that are drawn, with their material.
void draw_tree(PanelTools& tools) {
    const scene::Scene& scene = tools.stage.scene();
    const std::size_t count = scene::model_counts(scene).instances;
    ImGuiListClipper clipper;
    const float rows = static_cast<float>(std::min<std::size_t>(count, 8));
    ImGui::BeginChild("tree", {0.0F, rows * ImGui::GetTextLineHeightWithSpacing()});
    clipper.Begin(static_cast<int>(count));
    while (clipper.Step())
        for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
            const auto i = static_cast<std::size_t>(row);
            const scene::Instance& instance = scene.instances[i];
            const std::size_t material = scene.meshes[instance.mesh.index].material.index;
            ImGui::PushID(row);
            const std::string& name =
                instance.node.empty() ? scene.meshes[instance.mesh.index].name : instance.node;
            if (ImGui::Selectable((name + "###node").c_str(), tools.editor.material == material))
                tools.editor.material = material;
            tools.ui.mark(fmt::format("node[{}]", i));
            tooltip(scene.materials[material].name);
            ImGui::PopID();
        }
    ImGui::EndChild();
}

void draw_cameras(PanelTools& tools) {
    const scene::Scene& scene = tools.stage.scene();
    if (button(tools.ui, "frame_selected")) tools.editor.wanted.action = Action::frame_selected;
    tooltip(tools.ui.t("studio.frame_selected.help"));
    ImGui::SameLine();
    if (button(tools.ui, "view_home")) tools.editor.wanted.action = Action::view_home;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable((scene.cameras[i].name + "###camera").c_str()))
            tools.editor.document.settings.camera = fmt::format("{}", i);
        tools.ui.mark(fmt::format("camera[{}]", i));
        ImGui::PopID();
    }
}

}  // namespace

void draw_scene_panel(PanelTools& tools) {
    if (tools.lesson && section(tools.ui, "lesson")) draw_lesson(tools);
    if (section(tools.ui, "objects")) {
        draw_tree(tools);
        draw_variants(tools);
        draw_animation(tools);
    }
    if (section(tools.ui, "lights")) {
        draw_lights(tools);
        draw_settings_group(tools, "Light");
    }
    if (section(tools.ui, "camera")) {
        draw_cameras(tools);
        draw_settings_group(tools, "Camera");
    }
    if (section(tools.ui, "picture")) {
        draw_settings_group(tools, "Picture");
        draw_settings_group(tools, "Material");
    }
}

}  // namespace facet::studio
