// What panels are drawn with: texts, pictures, and a register of where each widget is, by which a
// script finds it. SPDX-License-Identifier: MIT
#pragma once

#include "base/texts.h"
#include "math/vector.h"
#include "studio/ui_renderer.h"

#include <imgui.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace facet::studio {

/// Where a widget was in the last frame. Names are the same in every language.
struct Widget {
    math::Vec2 low_px{0.0F};
    math::Vec2 high_px{0.0F};
    /// Of a slider: its ends, and whether it is logarithmic.
    std::optional<std::pair<float, float>> range;
    bool logarithmic = false;
    [[nodiscard]] math::Vec2 center_px() const { return (low_px + high_px) * 0.5F; }
};

struct Ui {
    const base::Texts& t;
    UiRenderer& pictures;
    float scale = 1.0F;  ///< pixels to one of the design
    std::map<std::string, Widget, std::less<>> widgets{};

    [[nodiscard]] float px(float design) const { return design * scale; }
    /// Registers the widget drawn last.
    void mark(std::string_view name);
    void mark_slider(std::string_view name, float low, float high, bool logarithmic);
};

/// The text of `key` with an id that does not depend on the language.
[[nodiscard]] std::string labelled(const Ui& ui, std::string_view key);

/// A combo box of the item width, registered as `name` whether it is open or not.
[[nodiscard]] bool begin_combo(Ui& ui, const std::string& name, const char* shown);
/// Widgets whose text is `studio.NAME` and that are registered as NAME.
[[nodiscard]] bool button(Ui& ui, std::string_view name);
[[nodiscard]] bool small_button(Ui& ui, std::string_view name);
[[nodiscard]] bool menu_item(Ui& ui, std::string_view name, const char* keys = nullptr,
                             bool selected = false, bool enabled = true);
/// Shows `text` beside the mouse when it rests on the widget drawn last.
void tooltip(std::string_view text);
/// A small heading.
void heading(const char* text);
/// A row's label in a column of its own, and the width that is left for its widget.
void row_label(Ui& ui, std::string_view text, std::string_view help);
/// A picture by its slot; `uv_low`, `uv_high`: the part of it.
void picture(Slot slot, math::Vec2 size_px, math::Vec2 uv_low = {0.0F, 0.0F},
             math::Vec2 uv_high = {1.0F, 1.0F});
/// A slot as ImGui names textures.
[[nodiscard]] inline ImTextureID texture_id(Slot slot) {
    return reinterpret_cast<ImTextureID>(slot);
}

}  // namespace facet::studio
