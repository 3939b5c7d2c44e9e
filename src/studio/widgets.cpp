// Widgets for rows of the tables.
// SPDX-License-Identifier: MIT
#include "studio/widgets.h"

#include "math/blackbody.h"
#include "math/color.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace facet::studio {
namespace {

math::Vec3 to_srgb(const math::Vec3& linear) {
    return {math::srgb_from_linear(linear.x), math::srgb_from_linear(linear.y),
            math::srgb_from_linear(linear.z)};
}
math::Vec3 to_linear(const math::Vec3& srgb) {
    return {math::linear_from_srgb(srgb.x), math::linear_from_srgb(srgb.y),
            math::linear_from_srgb(srgb.z)};
}

std::string hex_of(const math::Vec3& srgb) {
    const auto code = [](float c) {
        return static_cast<unsigned>(std::lround(std::clamp(c, 0.0F, 1.0F) * 255.0F));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", code(srgb.x), code(srgb.y), code(srgb.z));
}

bool hex_field(Ui& ui, math::Vec3& linear) {
    std::array<char, 8> text{};
    const std::string now = hex_of(to_srgb(linear));
    std::copy(now.begin(), now.end(), text.begin());
    ImGui::SetNextItemWidth(ui.px(90.0F));
    if (!ImGui::InputText("##hex", text.data(), text.size(),
                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll))
        return false;
    const std::string_view typed(text.data());
    unsigned code = 0;
    const std::string_view digits = typed.starts_with('#') ? typed.substr(1) : typed;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.size() != 6 || parsed.ptr != digits.data() + 6) return false;
    linear = to_linear({static_cast<float>(code >> 16U) / 255.0F,
                        static_cast<float>((code >> 8U) & 255U) / 255.0F,
                        static_cast<float>(code & 255U) / 255.0F});
    return true;
}

/// Sets a colour of the same luminance, or as near as fits 0..1.
bool temperature_slider(Ui& ui, const std::string& name, math::Vec3& linear) {
    ImGuiStorage& memory = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("temperature");
    float kelvin = memory.GetFloat(id, 6500.0F);
    ImGui::SetNextItemWidth(ui.px(210.0F));
    const bool moved =
        ImGui::SliderFloat("##temperature", &kelvin, math::blackbody_min_k, math::blackbody_max_k,
                           "%.0f K", ImGuiSliderFlags_Logarithmic);
    ui.mark_slider(name + ".temperature", math::blackbody_min_k, math::blackbody_max_k, true);
    memory.SetFloat(id, kelvin);
    if (!moved) return false;
    const math::Vec3 color = math::blackbody_color(kelvin);
    linear = color / std::max({color.x, color.y, color.z});
    return true;
}

/// The popup of a colour.
bool color_popup(Ui& ui, const SliderSpec& spec, math::Vec3& linear) {
    bool changed = false;
    math::Vec3 srgb = to_srgb(linear);
    ImGui::TextDisabled("sRGB");
    ImGui::SetNextItemWidth(ui.px(210.0F));
    if (ImGui::ColorPicker3("##picker", &srgb.x,
                            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoLabel |
                                ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_NoOptions)) {
        linear = to_linear(srgb);
        changed = true;
    }
    changed = hex_field(ui, linear) || changed;
    ImGui::TextDisabled("%s", ui.t("studio.linear"));
    ImGui::SetNextItemWidth(ui.px(210.0F));
    changed = ImGui::DragFloat3("##linear", &linear.x, 0.002F, static_cast<float>(spec.range.low),
                                static_cast<float>(spec.range.high), "%.4f",
                                ImGuiSliderFlags_AlwaysClamp) ||
              changed;
    ImGui::TextDisabled("%s", ui.t("studio.temperature"));
    return temperature_slider(ui, spec.name, linear) || changed;
}

/// The small arrow at a row's end that puts the value back; room for it is always kept.
bool reset_button(Ui& ui, const SliderSpec& spec) {
    ImGui::SameLine();
    const ImVec2 size(ImGui::GetFrameHeight(), ImGui::GetFrameHeight());
    if (!spec.changed) {
        ImGui::Dummy(size);
        return false;
    }
    const bool pressed = ImGui::Button(("\xE2\x86\xBA##reset " + spec.name).c_str(), size);
    ui.mark(spec.name + ".reset");
    tooltip(ui.t("studio.reset_one"));
    return pressed;
}

float width_with_reset() {
    return ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() -
           ImGui::GetStyle().ItemSpacing.x;
}

}  // namespace

Touched number_row(Ui& ui, const SliderSpec& spec, float& value) {
    ImGui::PushID(spec.name.c_str());
    row_label(ui, spec.label, spec.help);
    ImGui::SetNextItemWidth(width_with_reset());
    const auto low = static_cast<float>(spec.slider.low);
    const auto high = static_cast<float>(spec.slider.high);
    const std::string format = "%.3f" + (spec.unit.empty() ? "" : " " + spec.unit);
    const int flags = spec.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    const float before = value;
    bool changed = ImGui::SliderFloat("##value", &value, low, high, format.c_str(), flags);
    ui.mark_slider(spec.name, low, high, spec.logarithmic);
    tooltip(spec.help);
    value =
        std::clamp(value, static_cast<float>(spec.range.low), static_cast<float>(spec.range.high));
    changed = changed && value != before;
    const bool reset = reset_button(ui, spec);
    ImGui::PopID();
    return reset ? Touched::reset : changed ? Touched::changed : Touched::no;
}

Touched toggle_row(Ui& ui, const SliderSpec& spec, bool& on) {
    row_label(ui, spec.label, spec.help);
    const bool clicked = ImGui::Checkbox(("##" + spec.name).c_str(), &on);
    ui.mark(spec.name);
    return clicked ? Touched::changed : Touched::no;
}

Touched color_row(Ui& ui, const SliderSpec& spec, math::Vec3& linear) {
    ImGui::PushID(spec.name.c_str());
    row_label(ui, spec.label, spec.help);
    const math::Vec3 srgb = to_srgb(linear);
    const ImVec4 shown(std::clamp(srgb.x, 0.0F, 1.0F), std::clamp(srgb.y, 0.0F, 1.0F),
                       std::clamp(srgb.z, 0.0F, 1.0F), 1.0F);
    const ImVec2 size(width_with_reset(), ImGui::GetFrameHeight());
    if (ImGui::ColorButton("##color", shown,
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop, size))
        ImGui::OpenPopup("color");
    ui.mark(spec.name);
    tooltip(spec.help);
    const bool reset = reset_button(ui, spec);
    bool changed = false;
    if (ImGui::BeginPopup("color")) {
        ImGui::TextUnformatted(spec.label.c_str());
        changed = color_popup(ui, spec, linear);
        ImGui::EndPopup();
    }
    if (changed)
        for (int c = 0; c < 3; ++c)
            linear[c] = std::clamp(linear[c], static_cast<float>(spec.range.low),
                                   static_cast<float>(spec.range.high));
    ImGui::PopID();
    return reset ? Touched::reset : changed ? Touched::changed : Touched::no;
}

bool choice_row(Ui& ui, const std::string& name, std::string_view label, std::string_view help,
                std::size_t& chosen, const std::vector<std::string>& names) {
    ImGui::PushID(name.c_str());
    row_label(ui, label, help);
    ImGui::SetNextItemWidth(-1.0F);
    bool changed = false;
    if (begin_combo(ui, name, chosen < names.size() ? names[chosen].c_str() : "")) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (ImGui::Selectable(names[i].c_str(), i == chosen)) {
                changed = i != chosen;
                chosen = i;
            }
            ui.mark(name + "." + names[i]);
        }
        ImGui::EndCombo();
    }
    ImGui::PopID();
    return changed;
}

}  // namespace facet::studio
