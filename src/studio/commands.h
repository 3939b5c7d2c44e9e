// What the menus do: opening and saving, and what happens by itself around that: keeping unsaved
// work, seeing files change. SPDX-License-Identifier: MIT
#pragma once

#include "studio/actions.h"
#include "studio/child.h"
#include "studio/config.h"
#include "studio/editor.h"
#include "studio/file_dialog.h"
#include "studio/input.h"
#include "studio/recovery.h"
#include "studio/stage.h"
#include "studio/watch.h"

#include <chrono>
#include <optional>
#include <string>

namespace facet::studio {

/// What commands work on; all of it outlives them.
struct CommandTools {
    Editor& editor;
    Stage& stage;
    Config& config;
    Ui& ui;
    bool steady = false;  ///< offscreen: no look at the clock, no recovery of other sessions' work
};

class Commands {
public:
    Commands(const CommandTools& tools, std::filesystem::path recovery_folder);

    void act(Action action);
    /// Errors: as Stage::open; what is open stays then.
    [[nodiscard]] base::Status open_scene(const Document& document);
    /// By ending: a scene, a material, or a picture (which a child process renders).
    [[nodiscard]] base::Status save_to(const std::filesystem::path& path);
    void drop_files(const Input& input);
    /// The dialogs that are open.
    void draw();
    /// What happens by itself; once a frame, after the panels.
    void update();
    /// The studio may close: nothing is unsaved, or that was said to be right.
    [[nodiscard]] bool may_close();
    /// Closes the studio and keeps no work.
    void discard() { recovery_.drop(); }
    /// Seconds until update() has something to look at.
    [[nodiscard]] bool is_busy() const { return child_.has_value(); }
    /// Some file was written since it was read: update() will do something about it.
    [[nodiscard]] bool sees_changes();

private:
    enum class Closing { no, asked, yes };

    void draw_recovered();
    void draw_closing();
    void draw_keys();
    void act_file(Action action);
    void act_edit(Action action);
    void act_view(Action action);
    void frame_selected();
    void choose_file(FilePurpose purpose, const std::string& name);
    void take_file(FilePurpose purpose, const std::filesystem::path& path);
    [[nodiscard]] base::Status save_scene(const std::filesystem::path& path);
    [[nodiscard]] base::Status save_material(const std::filesystem::path& path);
    [[nodiscard]] base::Status save_picture(const std::filesystem::path& path);
    [[nodiscard]] std::filesystem::path scene_folder() const;
    /// The command's document, where the file that it names holds what the studio began with.
    [[nodiscard]] base::Result<Document> command_document() const;
    void keep_work();
    void look_at_files();
    void take_child();
    [[nodiscard]] std::size_t material() const;

    CommandTools tools_;
    FileDialog dialog_;
    std::optional<std::size_t> texture_slot_;  ///< for which a texture is chosen
    Recovery recovery_;
    std::optional<Recovered> recovered_;
    std::optional<tables::Settings> kept_;  ///< what recovery_ holds
    Watch scene_files_;
    Watch shader_files_;
    std::chrono::steady_clock::time_point looked_{};
    bool scene_changed_ = false;
    bool shaders_changed_ = false;
    std::optional<Child> child_;
    std::filesystem::path child_output_;
    Closing closing_ = Closing::no;
    bool shows_keys_ = false;
    /// Settings that were written into the open scene's own file.
    std::optional<tables::Settings> saved_over_;
};

}  // namespace facet::studio
