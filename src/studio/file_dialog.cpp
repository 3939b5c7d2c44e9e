// Choosing a file.
// SPDX-License-Identifier: MIT
#include "studio/file_dialog.h"

#include "base/text.h"
#include "tables/image_formats.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>

namespace facet::studio {
namespace {

namespace fs = std::filesystem;

/// Folders with more entries show the first of them.
constexpr std::size_t most_entries = 5000;

bool saves(FilePurpose purpose) {
    return purpose == FilePurpose::save_scene || purpose == FilePurpose::save_material ||
           purpose == FilePurpose::save_picture;
}

std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::vector<std::string> picture_endings(bool to_write) {
    std::vector<std::string> out;
    for (const tables::ImageFormatRow& row : tables::image_formats)
        if (to_write ? row.writes : row.reads)
            for (const std::string_view ending : base::split(row.endings, ','))
                out.push_back("." + std::string(ending));
    return out;
}

const char* title_key(FilePurpose purpose) {
    constexpr std::array keys = {"studio.open",          "studio.open_environment",
                                 "studio.open_texture",  "studio.save_as",
                                 "studio.save_material", "studio.save_picture"};
    return keys[static_cast<std::size_t>(purpose)];
}

std::string size_text(std::uintmax_t bytes) {
    if (bytes < 1024) return fmt::format("{} B", bytes);
    if (bytes < 1024 * 1024) return fmt::format("{} KiB", bytes >> 10U);
    return fmt::format("{} MiB", bytes >> 20U);
}

}  // namespace

std::vector<std::string> endings_for(FilePurpose purpose) {
    switch (purpose) {
        case FilePurpose::open_scene:
        case FilePurpose::save_scene:
            return {".glb", ".gltf"};
        case FilePurpose::open_environment:
            return {".hdr", ".exr"};
        case FilePurpose::open_texture:
            return picture_endings(false);
        case FilePurpose::save_material:
            return {".json"};
        case FilePurpose::save_picture:
            return picture_endings(true);
    }
    return {};
}

bool has_ending(const fs::path& path, FilePurpose purpose) {
    const auto endings = endings_for(purpose);
    return std::find(endings.begin(), endings.end(), lower_case(path.extension().string())) !=
           endings.end();
}

void FileDialog::open(FilePurpose purpose, const fs::path& path) {
    purpose_ = purpose;
    is_open_ = true;
    is_new_ = true;
    asks_to_replace_ = false;
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    if (fs::is_directory(absolute, error)) {
        name_.clear();
        enter(absolute);
    } else {
        name_ = saves(purpose) ? absolute.filename().string() : "";
        enter(absolute.parent_path());
    }
}

void FileDialog::enter(const fs::path& folder) {
    std::error_code error;
    folder_ = fs::weakly_canonical(folder, error);
    if (error) folder_ = folder;
    entries_.clear();
    trouble_.clear();
    fs::directory_iterator at(folder_, fs::directory_options::skip_permission_denied, error);
    for (; !error && at != fs::directory_iterator() && entries_.size() < most_entries;
         at.increment(error)) {
        std::error_code ignored;
        Entry entry{.name = at->path().filename().string(), .is_folder = at->is_directory(ignored)};
        if (entry.name.starts_with('.')) continue;
        if (!entry.is_folder && !has_ending(at->path(), purpose_)) continue;
        if (!entry.is_folder) entry.bytes = at->file_size(ignored);
        entries_.push_back(std::move(entry));
    }
    if (error) trouble_ = error.message();
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
    });
}

void FileDialog::draw_folder_bar(Ui& ui) {
    if (ImGui::Button("\xE2\x86\x91")) enter(folder_.parent_path());
    ui.mark("dialog.up");
    ImGui::SameLine();
    std::array<char, 1024> text{};
    const std::string now = folder_.string();
    std::copy_n(now.begin(), std::min(now.size(), text.size() - 1), text.begin());
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::InputText("##folder", text.data(), text.size(),
                         ImGuiInputTextFlags_EnterReturnsTrue)) {
        std::error_code error;
        const fs::path typed(text.data());
        if (fs::is_directory(typed, error))
            enter(typed);
        else
            trouble_ = ui.t("studio.no_such_folder");
    }
    ui.mark("dialog.folder");
}

bool FileDialog::draw_entries(Ui& ui) {
    bool accepted = false;
    std::optional<fs::path> next;
    ImGui::BeginChild("entries", {0.0F, -2.4F * ImGui::GetFrameHeightWithSpacing()}, true);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(entries_.size()));
    while (clipper.Step())
        for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
            const Entry& entry = entries_[static_cast<std::size_t>(row)];
            const std::string shown =
                (entry.is_folder ? entry.name + "/" : entry.name) + "###" + entry.name;
            const bool chosen = ImGui::Selectable(
                shown.c_str(), entry.name == name_,
                ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups);
            ui.mark("dialog." + entry.name);
            if (!entry.is_folder) {
                ImGui::SameLine(ImGui::GetContentRegionAvail().x - ui.px(70.0F));
                ImGui::TextDisabled("%s", size_text(entry.bytes).c_str());
            }
            if (!chosen) continue;
            if (entry.is_folder && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
                next = folder_ / entry.name;
            else if (!entry.is_folder)
                name_ = entry.name;
            accepted = !entry.is_folder && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        }
    if (!trouble_.empty()) ImGui::TextDisabled("%s", trouble_.c_str());
    ImGui::EndChild();
    if (next) enter(*next);
    return accepted;
}

std::optional<fs::path> FileDialog::draw_buttons(Ui& ui, bool accepted) {
    std::array<char, 512> text{};
    std::copy_n(name_.begin(), std::min(name_.size(), text.size() - 1), text.begin());
    ImGui::SetNextItemWidth(-1.0F);
    if (is_new_ && saves(purpose_)) ImGui::SetKeyboardFocusHere();
    accepted = ImGui::InputText("##name", text.data(), text.size(),
                                ImGuiInputTextFlags_EnterReturnsTrue) ||
               accepted;
    ui.mark("dialog.name");
    if (name_ != text.data()) asks_to_replace_ = false;
    name_ = text.data();
    accepted = button(ui, asks_to_replace_  ? "replace"
                          : saves(purpose_) ? "save_here"
                                            : "open_this") ||
               accepted;
    ImGui::SameLine();
    if (button(ui, "cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
        is_open_ = false;
    if (asks_to_replace_) {
        ImGui::SameLine();
        ImGui::TextUnformatted(ui.t("studio.replace_question"));
    }
    if (!accepted || name_.empty()) return std::nullopt;
    const fs::path path = folder_ / name_;
    std::error_code error;
    if (fs::is_directory(path, error)) {
        enter(path);
        name_.clear();
        return std::nullopt;
    }
    if (saves(purpose_) && fs::exists(path, error) && !asks_to_replace_) {
        asks_to_replace_ = true;
        return std::nullopt;
    }
    is_open_ = false;
    return path;
}

std::optional<fs::path> FileDialog::draw(Ui& ui) {
    if (!is_open_) return std::nullopt;
    const std::string title = std::string(ui.t(title_key(purpose_))) + "###dialog";
    if (is_new_) ImGui::OpenPopup(title.c_str());
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowSize(
        {std::min(ui.px(640.0F), window.x * 0.9F), std::min(ui.px(480.0F), window.y * 0.85F)},
        ImGuiCond_Appearing);
    ImGui::SetNextWindowPos({window.x * 0.5F, window.y * 0.5F}, ImGuiCond_Appearing, {0.5F, 0.5F});
    if (!ImGui::BeginPopupModal(title.c_str(), nullptr, ImGuiWindowFlags_NoSavedSettings))
        return std::nullopt;
    draw_folder_bar(ui);
    const bool accepted = draw_entries(ui);
    const auto chosen = draw_buttons(ui, accepted);
    is_new_ = false;
    if (!is_open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

}  // namespace facet::studio
