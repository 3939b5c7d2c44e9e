// Materials to begin with.
// SPDX-License-Identifier: MIT
#include "studio/preset_panel.h"

#include "scene/material_file.h"
#include "studio/thumbnails.h"

namespace facet::studio {
namespace {

constexpr float side_points = 84.0F;
constexpr int across = 5;

/// The preset's numbers as edits; the textures that would multiply them go.
void use_preset(PanelTools& tools, std::size_t material, const std::string& name) {
    const auto file = scene::load_material(name, {});
    if (!file) return tools.editor.complain(file.error());
    scene::Material changed = tools.stage.materials()[material];
    scene::apply_material(*file, changed);
    tools.editor.history.seal();
    tools.editor.edit("preset " + name, [&](tables::Settings& settings) {
        for (const tables::MaterialParam& param : tables::material_params) {
            const std::string path = material_path(material, param.key);
            if (const auto* field = std::get_if<float tables::MaterialValues::*>(&param.field))
                set_path(settings, path, number_text(changed.values.**field));
            else
                set_path(
                    settings, path,
                    vector_text(changed.values.*
                                std::get<tables::Color tables::MaterialValues::*>(param.field)));
        }
        for (const tables::MaterialTexture& row : tables::material_textures)
            set_path(settings, material_path(material, row.key), "none");
    });
}

}  // namespace

void draw_presets(PanelTools& tools, std::size_t material) {
    if (button(tools.ui, "presets")) ImGui::OpenPopup("presets");
    tooltip(tools.ui.t("studio.presets.help"));
    if (!ImGui::BeginPopup("presets")) return;
    tools.editor.wanted.thumbnails = true;
    const float side = tools.ui.px(side_points);
    const auto& names = tools.thumbnails.names();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i % across != 0) ImGui::SameLine();
        ImGui::BeginGroup();
        const Slot slot = Thumbnails::slot_of(i);
        ImGui::PushID(static_cast<int>(i));
        const bool chosen =
            tools.ui.pictures.has(slot)
                ? ImGui::ImageButton(texture_id(slot), {side, side}, {0, 0}, {1, 1}, 2)
                : ImGui::Button("...", {side + 4.0F, side + 4.0F});
        tools.ui.mark("preset." + names[i]);
        ImGui::PopID();
        const std::string_view label = tools.ui.t.or_else("preset." + names[i], names[i]);
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + side);
        ImGui::TextDisabled("%.*s", static_cast<int>(label.size()), label.data());
        ImGui::PopTextWrapPos();
        ImGui::EndGroup();
        if (chosen) {
            use_preset(tools, material, names[i]);
            ImGui::CloseCurrentPopup();
        }
    }
    ImGui::EndPopup();
}

}  // namespace facet::studio
