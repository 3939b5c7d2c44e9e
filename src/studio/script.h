// A script that works the studio as a person would: what --do reads.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "studio/input.h"
#include "studio/ui.h"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace facet::studio {

enum class Verb { set, click, drag, key, type, open, save, undo, redo, wait, truth, shot, quit };

struct ScriptStep {
    Verb verb = Verb::wait;
    std::vector<std::string> words;  ///< after the verb
    std::size_t line = 0;            ///< from 1
};

/// One step a line; `#` begins a comment, words with spaces stand in double quotes.
///   set PATH VALUE      what --set takes, or a setting's key and its value
///   click LABEL         presses a widget
///   drag LABEL X [Y]    a slider to the value X; anything else by X and Y pixels
///   key NAME            a key, "ctrl+z" with others held
///   type TEXT           letters into the field that has the focus
///   open FILE, save FILE, undo, redo, quit
///   wait N              N frames; without N until the picture is finished
///   truth N             until the reference beside the picture has N samples a pixel
///   shot FILE           the window as a PNG
/// Errors: usage, naming the line.
[[nodiscard]] base::Result<std::vector<ScriptStep>> parse_script(std::string_view text,
                                                                 const std::string& file);

/// How far what is drawn has come.
struct PlayProgress {
    bool picture_finished = false;  ///< nothing is left to draw or to save
    double reference_samples = 0.0;
    bool is_compared = false;  ///< and the difference to the reference is known
};

/// Plays a script, a frame at a time: mouse and keys into the input, the rest through `act`.
class ScriptPlayer {
public:
    /// Does a step that is no input. Errors end the script.
    using Act = std::function<base::Status(const ScriptStep&)>;

    explicit ScriptPlayer(std::vector<ScriptStep> steps) : steps_(std::move(steps)) {}
    [[nodiscard]] bool is_done() const { return next_ >= steps_.size(); }
    /// Before a frame: what the person does in it.
    [[nodiscard]] base::Status play(Input& input, const Ui& ui, const PlayProgress& progress,
                                    const Act& act);
    /// Nothing happens before the reference is better.
    [[nodiscard]] bool waits_for_truth() const {
        return !is_done() && steps_[next_].verb == Verb::truth;
    }

private:
    [[nodiscard]] base::Status play_step(const ScriptStep& step, Input& input, const Ui& ui,
                                         const PlayProgress& progress, const Act& act);
    /// The widget a step is about; null while it may still appear.
    [[nodiscard]] base::Result<const Widget*> find(const ScriptStep& step, const Ui& ui) const;
    void click(Input& input);
    [[nodiscard]] base::Status drag(const ScriptStep& step, Input& input);
    [[nodiscard]] base::Status press(const ScriptStep& step, Input& input);
    void done() {
        ++next_;
        frame_ = 0;
        waited_ = 0;
    }

    std::vector<ScriptStep> steps_;
    std::size_t next_ = 0;
    std::size_t frame_ = 0;   ///< of the current step
    std::size_t waited_ = 0;  ///< frames, for its widget
    Widget widget_;           ///< as it was in the step's first frame
    math::Vec2 from_px_{0.0F};
    math::Vec2 to_px_{0.0F};
};

}  // namespace facet::studio
