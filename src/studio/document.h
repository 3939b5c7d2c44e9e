// What the studio edits: a scene's name and the settings of its picture. Every edit is a change of
// the settings that the command line could have typed. SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "scene/scene.h"
#include "tables/settings.h"

#include <string>
#include <string_view>
#include <vector>

namespace facet::studio {

struct Document {
    std::string scene;
    tables::Settings settings;
};

/// A float in as few decimals as read back to the same float.
[[nodiscard]] std::string number_text(float value);
/// `x y z`.
[[nodiscard]] std::string vector_text(const math::Vec3& value);

/// "material[3].roughness".
[[nodiscard]] std::string material_path(std::size_t index, std::string_view key);
[[nodiscard]] std::string light_path(std::size_t index, std::string_view key);

/// `PATH=VALUE` among the settings' `set`, in place of an earlier one of the same path.
void set_path(tables::Settings& settings, const std::string& path, const std::string& value);
/// Takes back what set_path() gave `path`; where it ends in a dot, every path that begins so.
void clear_path(tables::Settings& settings, std::string_view path);
/// Whether set_path() gave a value to `path`, or to one that begins so where it ends in a dot.
[[nodiscard]] bool has_path(const tables::Settings& settings, std::string_view path);

/// What set_path() gave `path`; empty where it gave nothing.
[[nodiscard]] std::string path_value(const tables::Settings& settings, std::string_view path);

/// Undo and redo without limit. An edit under the same name as the one before replaces it, until
/// it is sealed: a drag of a slider is one step.
class History {
public:
    /// `before`: the settings as they were, `now`: as they are.
    void record(const std::string& name, const tables::Settings& before);
    void seal() { open_.clear(); }
    [[nodiscard]] bool is_sealed() const { return open_.empty(); }
    [[nodiscard]] bool can_undo() const { return !done_.empty(); }
    [[nodiscard]] bool can_redo() const { return !undone_.empty(); }
    [[nodiscard]] std::size_t undo_count() const { return done_.size(); }
    /// What undo() would take back.
    [[nodiscard]] const std::string& last_name() const { return done_.back().name; }
    /// Swaps `settings` with the step before (after). Where the view looks from stays.
    void undo(tables::Settings& settings);
    void redo(tables::Settings& settings);
    void clear();
    /// Forgets the newest steps beyond `count`: they came to nothing.
    void keep(std::size_t count);

private:
    struct Step {
        std::string name;
        tables::Settings settings;
    };
    static void move(std::vector<Step>& from, std::vector<Step>& to, tables::Settings& settings);
    std::vector<Step> done_;
    std::vector<Step> undone_;
    std::string open_;  ///< name of the edit that may go on
};

}  // namespace facet::studio
