// The textures of a material.
// SPDX-License-Identifier: MIT
#include "studio/texture_rows.h"

#include "studio/texture_preview.h"

#include <spdlog/fmt/fmt.h>

#include <array>
#include <filesystem>

namespace facet::studio {
namespace {

constexpr std::uint32_t preview_px = 256;
constexpr std::array channel_names = {"RGB", "R", "G", "B", "A"};

/// The picture of a texture and the choice of its channel.
void draw_popup(PanelTools& tools, const scene::SceneImage& image, std::size_t slot) {
    ImGuiStorage& memory = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("channel");
    int channel = memory.GetInt(id, 0);
    ImGui::TextUnformatted(image.name.c_str());
    bool is_new = ImGui::IsWindowAppearing();
    for (int i = 0; i < static_cast<int>(channel_names.size()); ++i) {
        if (i > 0) ImGui::SameLine();
        is_new =
            ImGui::RadioButton(channel_names[static_cast<std::size_t>(i)], &channel, i) || is_new;
        tools.ui.mark(fmt::format("channel.{}", channel_names[static_cast<std::size_t>(i)]));
    }
    memory.SetInt(id, channel);
    ImGui::SameLine();
    if (small_button(tools.ui, "replace_texture")) tools.editor.wanted.texture = slot;
    const image::Image small = preview(*image.pixels, static_cast<Channel>(channel), preview_px);
    if (is_new)
        if (auto s = tools.ui.pictures.upload(tools.gl, Slot::texture, small); !s)
            tools.editor.complain(s.error());
    picture(Slot::texture, {static_cast<float>(small.size.width) * tools.ui.scale,
                            static_cast<float>(small.size.height) * tools.ui.scale});
    ImGui::TextDisabled("%u x %u, %u", image.pixels->size.width, image.pixels->size.height,
                        image.pixels->channels);
}

void draw_row(PanelTools& tools, std::size_t material, std::size_t slot) {
    Ui& ui = tools.ui;
    const tables::MaterialTexture& row = tables::material_textures[slot];
    const std::string key(row.key);
    const std::string path = material_path(material, key);
    const scene::Scene& scene = tools.stage.scene();
    const auto& texture = tools.stage.materials()[material].textures[slot];
    const bool is_changed = has_path(tools.editor.document.settings, path);
    ImGui::PushID(key.c_str());
    row_label(ui, ui.t.or_else("param." + key, row.key), ui.t.or_else("help." + key, row.help));
    const float side = ImGui::GetFrameHeight();
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = ImGui::GetContentRegionAvail().x - 2.0F * (side + gap);
    const bool has_pixels = texture && scene.images[texture->image.index].pixels != nullptr;
    const std::string name =
        texture ? std::filesystem::path(scene.images[texture->image.index].name).filename().string()
                : ui.t("studio.none");
    if (ImGui::Button((name + "###view").c_str(), {width, side})) {
        if (has_pixels)
            ImGui::OpenPopup("texture");
        else
            tools.editor.wanted.texture = slot;
    }
    ui.mark(key);
    tooltip(ui.t("studio.texture.help"));
    ImGui::SameLine();
    if (texture) {
        if (ImGui::Button("\xC3\x97", {side, side})) {
            tools.editor.history.seal();
            tools.editor.set(path, "none");
        }
        ui.mark(key + ".clear");
        tooltip(ui.t("studio.clear_texture"));
    } else {
        ImGui::Dummy({side, side});
    }
    ImGui::SameLine();
    if (is_changed) {
        if (ImGui::Button("\xE2\x86\xBA", {side, side})) tools.editor.clear(path);
        ui.mark(key + ".reset");
        tooltip(ui.t("studio.reset_one"));
    } else {
        ImGui::Dummy({side, side});
    }
    if (ImGui::BeginPopup("texture")) {
        draw_popup(tools, scene.images[texture->image.index], slot);
        ImGui::EndPopup();
    }
    ImGui::PopID();
}

}  // namespace

void draw_texture_rows(PanelTools& tools, std::size_t material) {
    for (std::size_t slot = 0; slot < tables::material_textures.size(); ++slot)
        draw_row(tools, material, slot);
}

}  // namespace facet::studio
