// The lights of the scene.
// SPDX-License-Identifier: MIT
#include "studio/light_rows.h"

#include "base/text.h"
#include "scene/light_spec.h"
#include "scene/spec.h"
#include "studio/widgets.h"
#include "tables/lights.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>

namespace facet::studio {
namespace {

using tables::LightKeyRow;
using tables::LightKeyType;

const tables::LightKindRow& kind_of(const scene::Light& light) {
    return tables::light_kinds[static_cast<std::size_t>(light.kind)];
}

/// Lights of the file come first; those the document adds follow.
std::size_t added_from(const Editor& editor, std::size_t light_count) {
    return light_count - std::min(light_count, editor.document.settings.light.size());
}

SliderSpec spec_of(const PanelTools& tools, const LightKeyRow& row, std::size_t light) {
    const std::string key(row.key);
    const bool narrow = row.slider.high > row.slider.low;
    return {.name = "light." + key,
            .label = std::string(tools.ui.t.or_else("light." + key, row.key)),
            .help = std::string(tools.ui.t.or_else("light.help." + key, row.help)),
            .unit = std::string(row.unit),
            .range = row.range,
            .slider = narrow ? row.slider : row.range,
            .logarithmic = row.logarithmic,
            .changed = has_path(tools.editor.document.settings, light_path(light, row.key))};
}

Touched vector_row(Ui& ui, const SliderSpec& spec, math::Vec3& value) {
    row_label(ui, spec.label, spec.help);
    ImGui::SetNextItemWidth(-1.0F);
    const bool moved = ImGui::DragFloat3(("##" + spec.name).c_str(), &value.x, 0.01F,
                                         static_cast<float>(spec.range.low),
                                         static_cast<float>(spec.range.high), "%.3f");
    ui.mark(spec.name);
    return moved ? Touched::changed : Touched::no;
}

Touched text_row(Ui& ui, const SliderSpec& spec, std::string& value) {
    std::array<char, 128> text{};
    std::copy_n(value.begin(), std::min(value.size(), text.size() - 1), text.begin());
    row_label(ui, spec.label, spec.help);
    ImGui::SetNextItemWidth(-1.0F);
    const bool typed = ImGui::InputText(("##" + spec.name).c_str(), text.data(), text.size(),
                                        ImGuiInputTextFlags_EnterReturnsTrue);
    ui.mark(spec.name);
    value = text.data();
    return typed ? Touched::changed : Touched::no;
}

void draw_key(PanelTools& tools, const LightKeyRow& row, std::size_t index) {
    const scene::Light& light = tools.stage.lights()[index];
    const SliderSpec spec = spec_of(tools, row, index);
    std::string text = scene::light_key_text(light, row.key);
    // A light keeps the colour of its temperature, and not the temperature.
    if (text.empty()) text = path_value(tools.editor.document.settings, light_path(index, row.key));
    Touched touched = Touched::no;
    if (row.type == LightKeyType::text) {
        touched = text_row(tools.ui, spec, text);
    } else if (row.type == LightKeyType::toggle) {
        bool on = text == "on";
        touched = toggle_row(tools.ui, spec, on);
        text = on ? "on" : "off";
    } else if (row.type == LightKeyType::number) {
        float value = static_cast<float>(base::parse_number(text).value_or(6500.0));
        touched = number_row(tools.ui, spec, value);
        text = number_text(value);
    } else {
        math::Vec3 value = scene::parse_vector(row.key, text, row.range).value_or(math::Vec3(0.0F));
        touched = row.type == LightKeyType::color ? color_row(tools.ui, spec, value)
                                                  : vector_row(tools.ui, spec, value);
        text = vector_text(value);
    }
    const std::string path = light_path(index, row.key);
    if (touched == Touched::changed) tools.editor.set(path, text);
    if (touched == Touched::reset) tools.editor.clear(path);
}

void add_light(PanelTools& tools, std::string_view kind) {
    const math::Bounds bounds = tools.stage.scene().bounds_m();
    const float size = std::max(bounds.diagonal(), 1e-3F);
    const math::Vec3 at = bounds.center() + math::Vec3(0.4F, 0.7F, 0.6F) * size;
    std::string spec = std::string(kind) + ":name=" + std::string(kind) +
                       fmt::format("-{}", tools.stage.lights().size() + 1);
    const auto& row = *std::find_if(tables::light_kinds.begin(), tables::light_kinds.end(),
                                    [&](const auto& r) { return r.key == kind; });
    const auto has = [&](std::string_view key) {
        const auto keys = base::split(row.keys, ',');
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    // Bright enough to be seen at its distance.
    if (has("lux")) spec += ",azimuth=45,elevation=40,lux=3";
    if (has("candela")) {
        spec += ",position=" + vector_text(at) + ",candela=" + number_text(3.0F * size * size);
        if (has("target")) spec += ",target=" + vector_text(bounds.center());
    }
    tools.editor.history.seal();
    tools.editor.edit("add light", [&](tables::Settings& s) { s.light.push_back(spec); });
    tools.editor.light = tools.stage.lights().size();
}

void draw_list(PanelTools& tools) {
    const auto& lights = tools.stage.lights();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string text = lights[i].name + "###light";
        if (ImGui::Selectable(text.c_str(), tools.editor.light == i)) {
            tools.editor.light =
                tools.editor.light == i ? std::nullopt : std::optional<std::size_t>(i);
        }
        tools.ui.mark(fmt::format("light[{}]", i));
        tooltip(kind_of(lights[i]).help);
        ImGui::PopID();
    }
    if (lights.empty()) ImGui::TextDisabled("%s", tools.ui.t("studio.no_lights"));
}

void draw_add(PanelTools& tools) {
    if (button(tools.ui, "add_light")) ImGui::OpenPopup("kinds");
    if (!ImGui::BeginPopup("kinds")) return;
    for (const tables::LightKindRow& row : tables::light_kinds) {
        const std::string key(row.key);
        if (ImGui::MenuItem(std::string(tools.ui.t.or_else("light.kind." + key, key)).c_str(),
                            nullptr))
            add_light(tools, row.key);
        tools.ui.mark("add_light." + key);
        tooltip(row.help);
    }
    ImGui::EndPopup();
}

}  // namespace

void remove_light(Editor& editor, std::size_t light_count, std::size_t light) {
    const std::size_t first = added_from(editor, light_count);
    if (light < first || light >= light_count) return;
    editor.history.seal();
    editor.edit("remove light", [&](tables::Settings& settings) {
        settings.light.erase(settings.light.begin() + static_cast<std::ptrdiff_t>(light - first));
        clear_path(settings, light_path(light, ""));
        // Those behind it move up.
        for (std::size_t i = light + 1; i < light_count; ++i) {
            const std::string old = light_path(i, "");
            for (std::string& text : settings.set)
                if (text.starts_with(old)) text = light_path(i - 1, "") + text.substr(old.size());
        }
    });
    editor.light = std::nullopt;
}

void draw_lights(PanelTools& tools) {
    const auto& lights = tools.stage.lights();
    draw_list(tools);
    draw_add(tools);
    if (!tools.editor.light || *tools.editor.light >= lights.size()) return;
    const std::size_t index = *tools.editor.light;
    ImGui::SameLine();
    ImGui::BeginDisabled(index < added_from(tools.editor, lights.size()));
    const bool removed = button(tools.ui, "remove_light");
    ImGui::EndDisabled();
    if (removed) return remove_light(tools.editor, lights.size(), index);
    const auto keys = base::split(kind_of(lights[index]).keys, ',');
    for (const LightKeyRow& row : tables::light_keys)
        if (!row.write_only && std::find(keys.begin(), keys.end(), row.key) != keys.end())
            draw_key(tools, row, index);
}

}  // namespace facet::studio
