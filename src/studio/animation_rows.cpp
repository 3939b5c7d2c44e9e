// Rows of what a file has more than one of: its animations, and sets of its materials.
// SPDX-License-Identifier: MIT
#include "studio/animation_rows.h"

#include "scene/rig.h"
#include "studio/widgets.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::studio {
namespace {

using tables::Settings;

/// A choice among names, the first of which stands for none: as the file has it.
bool choose_one(PanelTools& tools, const char* key, const std::vector<std::string>& names,
                std::size_t& chosen) {
    std::vector<std::string> shown{"-"};
    shown.insert(shown.end(), names.begin(), names.end());
    return choice_row(tools.ui, key, tools.ui.t(std::string("studio.") + key),
                      tools.ui.t(std::string("studio.") + key + ".help"), chosen, shown);
}

std::size_t first_of(const std::vector<std::string>& names, const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// What --animation calls a clip: its name, or the index where an earlier one has that name.
std::string name_of_clip(const std::vector<std::string>& names, std::size_t index) {
    return first_of(names, names[index]) == index ? names[index] : std::to_string(index);
}

/// The place of the clip that is played among the names, from 1; 0: none is.
std::size_t played(const Settings& settings, const std::vector<std::string>& names) {
    if (!settings.time && settings.animation.empty()) return 0;
    std::size_t index = first_of(names, settings.animation);
    for (std::size_t i = 0; index == names.size() && i < names.size(); ++i)
        if (settings.animation == std::to_string(i)) index = i;
    return index < names.size() ? index + 1 : 1;
}

}  // namespace

void draw_animation(PanelTools& tools) {
    const scene::Scene& scene = tools.stage.scene();
    if (scene.rig == nullptr) return;
    Editor& editor = tools.editor;
    std::size_t chosen = played(editor.document.settings, scene.animations);
    if (choose_one(tools, "animation", scene.animations, chosen)) {
        editor.plays = false;
        editor.edit("animation", [&](Settings& s) {
            s.animation = chosen == 0 ? "" : name_of_clip(scene.animations, chosen - 1);
            s.time = chosen == 0 ? std::nullopt : std::optional(0.0F);
        });
    }
    if (chosen == 0) return;
    if (button(tools.ui, editor.plays ? "pause" : "play")) editor.plays = !editor.plays;
    const float end_s = scene.rig->clips[chosen - 1].end_s;
    float time_s = editor.document.settings.time.value_or(0.0F);
    const SliderSpec spec{.name = "time",
                          .label = std::string(tools.ui.t("studio.time")),
                          .help = std::string(tools.ui.t("studio.time.help")),
                          .unit = "s",
                          .range = {0.0, static_cast<double>(end_s)},
                          .slider = {0.0, static_cast<double>(end_s)},
                          .changed = time_s != 0.0F};
    const Touched touched = number_row(tools.ui, spec, time_s);
    if (touched == Touched::no) return;
    editor.plays = false;
    editor.edit("time", [&](Settings& s) { s.time = touched == Touched::reset ? 0.0F : time_s; });
}

void draw_variants(PanelTools& tools) {
    const std::vector<std::string>& names = tools.stage.scene().variants;
    if (names.empty()) return;
    const std::string& now = tools.editor.document.settings.variant;
    const std::size_t found = first_of(names, now);
    std::size_t chosen = found == names.size() ? 0 : found + 1;
    if (!choose_one(tools, "variant", names, chosen)) return;
    tools.editor.edit("variant",
                      [&](Settings& s) { s.variant = chosen == 0 ? "" : names[chosen - 1]; });
}

}  // namespace facet::studio
