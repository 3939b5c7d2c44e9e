// The inspector.
// SPDX-License-Identifier: MIT
#include "studio/inspector.h"

#include "studio/inspection.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace facet::studio {
namespace {

constexpr ImU32 specular_color = IM_COL32(240, 170, 70, 255);
constexpr ImU32 diffuse_color = IM_COL32(90, 160, 235, 255);
constexpr ImU32 absorbed_color = IM_COL32(95, 95, 95, 255);

ImU32 text_color(float alpha = 1.0F) { return ImGui::GetColorU32(ImGuiCol_Text, alpha); }

std::string value_text(const Probed& probed) {
    const tables::AovRow& row = tables::row(probed.aov);
    const math::Vec3& v = probed.value;
    if (row.png == tables::PngCode::id_color) return fmt::format("{:.0f}", v.x);
    if (row.channels.size() == 1) return fmt::format("{:.4g}", v.x);
    return fmt::format("{:.4g}  {:.4g}  {:.4g}", v.x, v.y, v.z);
}

void draw_numbers(PanelTools& tools, const PixelFacts& facts) {
    Ui& ui = tools.ui;
    ImGui::Text("%s %.0f, %.0f", ui.t("studio.pixel"), static_cast<double>(facts.at_px.x),
                static_cast<double>(facts.at_px.y));
    if (facts.is_background) {
        ImGui::TextDisabled("%s", ui.t("studio.background"));
        return;
    }
    if (!ImGui::BeginTable("values", 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (const Probed& probed : facts.values) {
        const tables::AovRow& row = tables::row(probed.aov);
        const std::string key(row.key);
        ImGui::TableNextColumn();
        const std::string_view label = ui.t.or_else("view." + key, row.key);
        ImGui::TextDisabled("%.*s", static_cast<int>(label.size()), label.data());
        tooltip(ui.t.or_else("view.help." + key, row.help));
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(value_text(probed).c_str());
    }
    ImGui::EndTable();
}

/// A half circle with both lobes; the radius is the root of the value, so that a narrow lobe and a
/// wide one are both seen.
void draw_lobes(PanelTools& tools, const PixelFacts& facts) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = std::min(0.5F * width, tools.ui.px(92.0F));
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 origin(low.x + 0.5F * width, low.y + height);
    const float radius = std::min(0.5F * width, height) - tools.ui.px(4.0F);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine({origin.x - radius, origin.y}, {origin.x + radius, origin.y}, text_color(0.4F));
    list.AddLine(origin, {origin.x, origin.y - radius}, text_color(0.2F));
    const auto at = [&](float angle_deg, float r) {
        const float a = angle_deg * math::pi / 180.0F;
        return ImVec2(origin.x + r * std::sin(a), origin.y - r * std::cos(a));
    };
    float most = 1e-6F;
    for (std::size_t i = 0; i < Lobes::count; ++i)
        most = std::max(most, facts.lobes.specular[i] + facts.lobes.diffuse[i]);
    const auto curve = [&](const std::array<float, Lobes::count>& values, ImU32 color) {
        std::array<ImVec2, Lobes::count> points;
        for (std::size_t i = 0; i < Lobes::count; ++i)
            points[i] = at(static_cast<float>(i) - 90.0F, radius * std::sqrt(values[i] / most));
        list.AddPolyline(points.data(), static_cast<int>(points.size()), color, 0,
                         tools.ui.px(1.5F));
    };
    curve(facts.lobes.diffuse, diffuse_color);
    curve(facts.lobes.specular, specular_color);
    list.AddLine(origin, at(facts.lobes.view_deg, radius), text_color(0.8F), tools.ui.px(1.0F));
    ImGui::Dummy({width, height});
    ImGui::TextDisabled(
        "%s", fmt::format("{} {:.1f}\xC2\xB0   {} {:.3g} /sr", tools.ui.t("studio.view_angle"),
                          -facts.lobes.view_deg, tools.ui.t("studio.peak"), most)
                  .c_str());
}

/// The lecture's balance: reflected, refracted and scattered out again, absorbed; the sum is 1.
void draw_energy(PanelTools& tools, const Energy& energy) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = ImGui::GetFrameHeight() * 0.6F;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    struct Part {
        const char* key;
        float share;
        ImU32 color;
    };
    const std::array parts = {Part{"studio.reflected", energy.reflected, specular_color},
                              Part{"studio.scattered", energy.scattered, diffuse_color},
                              Part{"studio.absorbed", energy.absorbed, absorbed_color}};
    float x = low.x;
    for (const Part& part : parts) {
        const float right = std::min(low.x + width, x + part.share * width);
        list.AddRectFilled({x, low.y}, {right, low.y + height}, part.color);
        x = right;
    }
    ImGui::Dummy({width, height});
    tools.ui.mark("energy");
    tooltip(tools.ui.t("studio.energy.help"));
    for (const Part& part : parts) {
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(part.color), "\xE2\x96\xA0");
        ImGui::SameLine();
        ImGui::Text("%s %.3f", tools.ui.t(part.key), static_cast<double>(part.share));
    }
}

void draw_histogram(PanelTools& tools, const Histogram& histogram) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = tools.ui.px(90.0F);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + height},
                       ImGui::GetColorU32(ImGuiCol_FrameBg, 0.6F));
    float most = 1e-6F;
    for (const auto& channel : histogram.shares)
        // The ends are often spikes that would flatten the rest.
        for (std::size_t i = 1; i + 1 < Histogram::bin_count; ++i)
            most = std::max(most, channel[i]);
    constexpr std::array colors = {IM_COL32(235, 90, 90, 230), IM_COL32(100, 205, 100, 230),
                                   IM_COL32(95, 145, 245, 230)};
    for (std::size_t c = 0; c < 3; ++c) {
        std::array<ImVec2, Histogram::bin_count> points;
        for (std::size_t i = 0; i < Histogram::bin_count; ++i)
            points[i] = {low.x + width * (static_cast<float>(i) + 0.5F) / Histogram::bin_count,
                         low.y + height * (1.0F - std::min(1.0F, histogram.shares[c][i] / most))};
        list.AddPolyline(points.data(), static_cast<int>(points.size()), colors[c], 0,
                         tools.ui.px(1.3F));
    }
    ImGui::Dummy({width, height});
    tools.ui.mark("histogram");
    ImGui::TextDisabled("%s",
                        fmt::format("{} {:.2f} %   {} {:.2f} %", tools.ui.t("studio.blown"),
                                    histogram.clipped_high * 100.0F, tools.ui.t("studio.crushed"),
                                    histogram.clipped_low * 100.0F)
                            .c_str());
}

}  // namespace

void draw_inspector(PanelTools& tools) {
    const Inspection& seen = tools.inspection;
    if (!ImGui::BeginTable("inspector", 3, ImGuiTableFlags_BordersInnerV)) return;
    ImGui::TableSetupColumn("numbers", ImGuiTableColumnFlags_WidthStretch, 1.35F);
    ImGui::TableSetupColumn("lobes", ImGuiTableColumnFlags_WidthStretch, 1.0F);
    ImGui::TableSetupColumn("histogram", ImGuiTableColumnFlags_WidthStretch, 1.0F);
    ImGui::TableNextColumn();
    ImGui::BeginChild("numbers", {0.0F, 0.0F});
    if (seen.pixel)
        draw_numbers(tools, *seen.pixel);
    else
        ImGui::TextWrapped("%s", tools.ui.t("studio.probe_hint"));
    ImGui::EndChild();
    ImGui::TableNextColumn();
    if (seen.pixel && !seen.pixel->is_background) {
        draw_lobes(tools, *seen.pixel);
        draw_energy(tools, seen.pixel->energy);
    }
    ImGui::TableNextColumn();
    if (seen.histogram) draw_histogram(tools, *seen.histogram);
    if (seen.against.samples > 0.0) {
        ImGui::Text("%s", fmt::format("{} {:.0f}", tools.ui.t("studio.reference_samples"),
                                      seen.against.samples)
                              .c_str());
        if (seen.against.is_known)
            ImGui::Text(
                "%s", fmt::format("RMSE {:.4f}   FLIP {:.4f}", seen.against.rmse, seen.against.flip)
                          .c_str());
    }
    ImGui::EndTable();
}

}  // namespace facet::studio
