// Rows for the settings of a picture.
// SPDX-License-Identifier: MIT
#include "studio/settings_rows.h"

#include "base/text.h"
#include "scene/scene.h"
#include "studio/widgets.h"
#include "tables/environments.h"
#include "tables/tonemaps.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>

namespace facet::studio {
namespace {

using tables::Setting;
using tables::Settings;

/// Settings that other parts of the studio are for, or that a viewport has no use for.
constexpr std::array hidden = {
    "light",  "set",   "material",   "camera",     "aov",   "reference", "compare",   "time_limit",
    "region", "depth", "distortion", "aberration", "gamut", "time",      "animation", "variant"};

template <class Rows>
std::vector<std::string> keys(const Rows& rows) {
    std::vector<std::string> out;
    for (const auto& row : rows) out.emplace_back(row.key);
    return out;
}

/// What a text setting can be chosen from; empty where it is typed.
std::vector<std::string> choices(const Setting& row, const PanelTools& tools) {
    if (row.key == "tonemap") return keys(tables::tonemaps);
    if (row.key == "projection") return {"perspective", "orthographic"};
    if (row.key == "env") {
        auto names = keys(tables::environments);
        const std::string& now = tools.editor.document.settings.env;
        if (std::find(names.begin(), names.end(), now) == names.end()) names.push_back(now);
        return names;
    }
    std::vector<std::string> out;
    for (const std::string_view part : base::split(row.value, '|')) {
        if (part.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") != std::string_view::npos)
            return {};
        out.emplace_back(part);
    }
    return out;
}

struct Row {
    PanelTools& tools;
    const Setting& row;
    SliderSpec spec;

    void change(const std::function<void(Settings&)>& by) const {
        tools.editor.edit(std::string(row.key), by);
    }

    void operator()(float Settings::*field) const {
        float value = tools.editor.document.settings.*field;
        const Touched touched = number_row(tools.ui, spec, value);
        if (touched == Touched::reset) value = tools.editor.opened.*field;
        if (touched != Touched::no) change([&](Settings& s) { s.*field = value; });
    }
    void operator()(std::optional<float> Settings::*field) const {
        const auto& now = tools.editor.document.settings.*field;
        float value = now.value_or(0.0F);
        SliderSpec own = spec;
        own.changed = now.has_value();
        const Touched touched = number_row(tools.ui, own, value);
        if (touched == Touched::reset) change([&](Settings& s) { s.*field = std::nullopt; });
        if (touched == Touched::changed) change([&](Settings& s) { s.*field = value; });
    }
    void operator()(std::uint32_t Settings::*field) const {
        auto value = static_cast<int>(tools.editor.document.settings.*field);
        row_label(tools.ui, spec.label, spec.help);
        ImGui::SetNextItemWidth(-1.0F);
        if (ImGui::SliderInt(("##" + spec.name).c_str(), &value, static_cast<int>(spec.slider.low),
                             static_cast<int>(spec.slider.high), "%d",
                             ImGuiSliderFlags_AlwaysClamp))
            change([&](Settings& s) { s.*field = static_cast<std::uint32_t>(value); });
        tools.ui.mark_slider(spec.name, static_cast<float>(spec.slider.low),
                             static_cast<float>(spec.slider.high), false);
    }
    void operator()(bool Settings::*field) const {
        bool on = tools.editor.document.settings.*field;
        if (toggle_row(tools.ui, spec, on) == Touched::changed)
            change([&](Settings& s) { s.*field = on; });
    }
    void operator()(math::Extent Settings::*field) const {
        const math::Extent now = tools.editor.document.settings.*field;
        std::array<int, 2> sides = {static_cast<int>(now.width), static_cast<int>(now.height)};
        row_label(tools.ui, spec.label, spec.help);
        ImGui::SetNextItemWidth(-1.0F);
        const bool typed = ImGui::InputInt2(("##" + spec.name).c_str(), sides.data(),
                                            ImGuiInputTextFlags_EnterReturnsTrue);
        tools.ui.mark(spec.name);
        if (typed && sides[0] > 0 && sides[1] > 0)
            change([&](Settings& s) {
                s.*field = {static_cast<std::uint32_t>(sides[0]),
                            static_cast<std::uint32_t>(sides[1])};
            });
    }
    void operator()(std::string Settings::*field) const {
        const std::string& now = tools.editor.document.settings.*field;
        if (const auto names = choices(row, tools); !names.empty()) {
            auto chosen = static_cast<std::size_t>(std::find(names.begin(), names.end(), now) -
                                                   names.begin());
            if (choice_row(tools.ui, spec.name, spec.label, spec.help, chosen, names))
                change([&](Settings& s) { s.*field = names[chosen]; });
            return;
        }
        std::array<char, 256> text{};
        std::copy_n(now.begin(), std::min(now.size(), text.size() - 1), text.begin());
        row_label(tools.ui, spec.label, spec.help);
        ImGui::SetNextItemWidth(-1.0F);
        if (ImGui::InputTextWithHint(("##" + spec.name).c_str(), std::string(row.value).c_str(),
                                     text.data(), text.size(),
                                     ImGuiInputTextFlags_EnterReturnsTrue))
            change([&](Settings& s) { s.*field = text.data(); });
        tools.ui.mark(spec.name);
    }
    void operator()(std::vector<std::string> Settings::*) const {}  // no such row is shown
};

bool differs(const Editor& editor, const Setting& row) {
    return std::visit(
        [&](auto field) { return editor.document.settings.*field != editor.opened.*field; },
        row.field);
}

}  // namespace

void draw_settings_group(PanelTools& tools, std::string_view group) {
    for (const Setting& row : tables::settings) {
        if (row.group != group || std::find(hidden.begin(), hidden.end(), row.key) != hidden.end())
            continue;
        const std::string key(row.key);
        const bool narrow = row.slider.high > row.slider.low;
        const SliderSpec spec{
            .name = key,
            .label = std::string(tools.ui.t.or_else("setting." + key, row.key)),
            .help = std::string(tools.ui.t.or_else("setting.help." + key, row.help)),
            .unit = row.value == "DEG" ? "deg" : "",
            .range = row.range,
            .slider = narrow ? row.slider : row.range,
            .logarithmic = row.logarithmic,
            .changed = differs(tools.editor, row)};
        std::visit(Row{tools, row, spec}, row.field);
    }
}

}  // namespace facet::studio
