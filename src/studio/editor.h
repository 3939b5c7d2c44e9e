// What is being edited and looked at: the state that panels read and change.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "scene/scene.h"
#include "studio/actions.h"
#include "studio/document.h"
#include "studio/look.h"
#include "studio/orbit.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace facet::studio {

/// What a panel asks for and the studio does after the panels are drawn.
struct Wanted {
    std::optional<std::string> open;     ///< a scene
    std::optional<std::size_t> texture;  ///< slot that a file is to be chosen for
    std::optional<Action> action;
    bool copy_material = false;
    bool thumbnails = false;  ///< pictures of the presets
    bool quit = false;
    std::optional<std::size_t> lesson_view;
    std::optional<math::Vec2> pick_px;   ///< in the viewport's picture
    std::optional<math::Vec2> probe_px;  ///< likewise
};

struct Message {
    enum class Kind { note, warning, error };
    Kind kind = Kind::note;
    std::string text;
};

struct Editor {
    Document document;
    tables::Settings opened;  ///< as the scene was opened: what reset and compare go back to
    History history;
    bool unsaved = false;
    std::optional<std::size_t> material;  ///< selected
    std::optional<std::size_t> light;
    std::optional<std::size_t> lesson_view;  ///< that was gone to last
    Look look;
    std::optional<Orbit> orbit;  ///< how the view was last turned, unrounded
    bool plays = false;          ///< the animation goes on by itself
    std::vector<Message> messages;
    std::vector<std::pair<std::string, std::string>> copied_material;  ///< key and value
    Wanted wanted;

    /// Changes the settings as one step of undo; under the same `name` until the mouse is let go.
    void edit(const std::string& name, const std::function<void(tables::Settings&)>& change);
    /// `PATH=VALUE` as such a step.
    void set(const std::string& path, const std::string& value);
    void clear(const std::string& path);
    /// What was copied from one material, into another.
    void paste_material(std::size_t material);
    /// Turns the view; no step of undo. A camera of the file has an angle of its own, an orbit the
    /// default one: `fov_rad` is kept.
    void look_from(const Orbit& from, float fov_rad);
    /// Moves the animation on by that, and round at its end; no step of undo.
    void play(float passed_s, float end_s);
    void say(Message::Kind kind, std::string text);
    void complain(const base::Error& error) { say(Message::Kind::error, base::to_line(error)); }
};

}  // namespace facet::studio
