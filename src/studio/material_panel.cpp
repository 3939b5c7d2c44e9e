// The material panel: a row for every row of tables/material.def and tables/material_textures.def.
// SPDX-License-Identifier: MIT
#include "studio/panels.h"
#include "studio/preset_panel.h"
#include "studio/texture_rows.h"
#include "studio/widgets.h"

#include <algorithm>
#include <utility>

namespace facet::studio {
namespace {

using tables::MaterialParam;
using tables::MaterialValues;

std::string label_of(const Ui& ui, std::string_view key) {
    return std::string(ui.t.or_else("param." + std::string(key), key));
}
std::string help_of(const Ui& ui, std::string_view key, std::string_view help) {
    return std::string(ui.t.or_else("help." + std::string(key), help));
}

SliderSpec spec_of(const PanelTools& tools, const MaterialParam& param, std::size_t index) {
    const bool narrow = param.slider.high > param.slider.low;
    return {.name = std::string(param.key),
            .label = label_of(tools.ui, param.key),
            .help = help_of(tools.ui, param.key, param.help),
            .unit = "",
            .range = param.range,
            .slider = narrow ? param.slider : param.range,
            .logarithmic = param.logarithmic,
            .changed = has_path(tools.editor.document.settings, material_path(index, param.key))};
}

void draw_param(PanelTools& tools, const MaterialParam& param, std::size_t index,
                const MaterialValues& values) {
    const SliderSpec spec = spec_of(tools, param, index);
    const std::string path = material_path(index, param.key);
    Touched touched = Touched::no;
    std::string text;
    if (const auto* number = std::get_if<float MaterialValues::*>(&param.field)) {
        float value = values.**number;
        touched = number_row(tools.ui, spec, value);
        text = number_text(value);
    } else {
        math::Vec3 color = values.*std::get<tables::Color MaterialValues::*>(param.field);
        touched = color_row(tools.ui, spec, color);
        text = vector_text(color);
    }
    if (touched == Touched::changed) tools.editor.set(path, text);
    if (touched == Touched::reset) tools.editor.clear(path);
}

void choose_material(PanelTools& tools) {
    const auto& materials = tools.stage.materials();
    std::vector<std::string> names;
    for (const scene::Material& material : materials) names.push_back(material.name);
    std::size_t chosen = tools.editor.material.value_or(0);
    if (choice_row(tools.ui, "material", tools.ui.t("studio.material"), "", chosen, names))
        tools.editor.material = chosen;
}

/// Key and value of everything the material has, for another one.
std::vector<std::pair<std::string, std::string>> values_of(const scene::Material& material) {
    std::vector<std::pair<std::string, std::string>> out;
    for (const MaterialParam& param : tables::material_params) {
        std::string text;
        if (const auto* number = std::get_if<float MaterialValues::*>(&param.field))
            text = number_text(material.values.**number);
        else
            text = vector_text(material.values.*
                               std::get<tables::Color MaterialValues::*>(param.field));
        out.emplace_back(param.key, std::move(text));
    }
    return out;
}

void draw_tools(PanelTools& tools, std::size_t index) {
    Ui& ui = tools.ui;
    Editor& editor = tools.editor;
    const bool copies = button(ui, "copy") || std::exchange(editor.wanted.copy_material, false);
    if (copies) editor.copied_material = values_of(tools.stage.materials()[index]);
    tooltip(ui.t("studio.copy.help"));
    ImGui::SameLine();
    if (button(ui, "paste")) editor.paste_material(index);
    tooltip(ui.t("studio.paste.help"));
    ImGui::SameLine();
    if (button(ui, "reset")) editor.clear(material_path(index, ""));
    tooltip(ui.t("studio.reset.help"));
    draw_presets(tools, index);
    ImGui::SameLine();
    ImGui::Checkbox(labelled(ui, "studio.solo").c_str(), &editor.look.solo);
    ui.mark("solo");
    tooltip(ui.t("studio.solo.help"));
}

}  // namespace

void draw_material_panel(PanelTools& tools) {
    const auto& materials = tools.stage.materials();
    if (materials.empty()) {
        ImGui::TextDisabled("%s", tools.ui.t("studio.no_materials"));
        return;
    }
    choose_material(tools);
    const std::size_t index = std::min(tools.editor.material.value_or(0), materials.size() - 1);
    tools.editor.material = index;
    draw_tools(tools, index);
    heading(tools.ui.t("studio.parameters"));
    for (const MaterialParam& param : tables::material_params)
        draw_param(tools, param, index, materials[index].values);
    heading(tools.ui.t("studio.textures"));
    draw_texture_rows(tools, index);
}

}  // namespace facet::studio
