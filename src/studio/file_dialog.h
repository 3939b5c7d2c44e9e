// Choosing a file, drawn like everything else: the same with and without a desktop.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/ui.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace facet::studio {

/// What the file is chosen for.
enum class FilePurpose {
    open_scene,
    open_environment,
    open_texture,
    save_scene,
    save_material,
    save_picture
};

class FileDialog {
public:
    /// Opens at `path`, a folder or a file in one.
    void open(FilePurpose purpose, const std::filesystem::path& path);
    [[nodiscard]] bool is_open() const { return is_open_; }
    [[nodiscard]] FilePurpose purpose() const { return purpose_; }
    /// Draws the dialog, where it is open; gives the file when one was chosen.
    [[nodiscard]] std::optional<std::filesystem::path> draw(Ui& ui);

private:
    struct Entry {
        std::string name;
        bool is_folder = false;
        std::uintmax_t bytes = 0;
    };
    void enter(const std::filesystem::path& folder);
    void draw_folder_bar(Ui& ui);
    [[nodiscard]] bool draw_entries(Ui& ui);
    [[nodiscard]] std::optional<std::filesystem::path> draw_buttons(Ui& ui, bool accepted);

    FilePurpose purpose_ = FilePurpose::open_scene;
    bool is_open_ = false;
    bool is_new_ = false;
    std::filesystem::path folder_;
    std::vector<Entry> entries_;
    std::string trouble_;  ///< why the folder could not be read
    std::string name_;
    bool asks_to_replace_ = false;
};

/// The endings that a purpose takes, lower case, with the dot.
[[nodiscard]] std::vector<std::string> endings_for(FilePurpose purpose);
[[nodiscard]] bool has_ending(const std::filesystem::path& path, FilePurpose purpose);

}  // namespace facet::studio
