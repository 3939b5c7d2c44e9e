// A script that works the studio as a person would: playing it.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "studio/script.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

namespace facet::studio {
namespace {

/// Frames that a widget may take to appear: menus open one frame after the click, files load.
constexpr std::size_t patience = 120;
/// Frames that a drag takes on its way.
constexpr std::size_t drag_frames = 8;
/// Of ImGui 1.86, imgui_widgets.cpp, SliderBehaviorT: between a slider's frame and its grab.
constexpr float grab_padding_px = 2.0F;

tl::unexpected<base::Error> failed(const ScriptStep& step, std::string what, std::string found,
                                   std::string remedy) {
    return base::fail({.code = base::ErrorCode::usage,
                       .file = "--do",
                       .where = fmt::format("line {}", step.line),
                       .what = std::move(what),
                       .found = std::move(found),
                       .remedy = std::move(remedy)});
}

/// Where a slider's grab has to be for `value`.
math::Vec2 place_of(const Widget& widget, float value) {
    const auto [low, high] = *widget.range;
    float share = (value - low) / (high - low);
    if (widget.logarithmic) {
        // ImGui's scale ends at 0.001, the precision of "%.3f", where the range ends at 0.
        constexpr float least = 0.001F;
        const float from = std::max(low, least);
        share = value <= from ? 0.0F : std::log(value / from) / std::log(high / from);
    }
    const float grab = ImGui::GetStyle().GrabMinSize;
    const float left = widget.low_px.x + grab_padding_px + grab * 0.5F;
    const float right = widget.high_px.x - grab_padding_px - grab * 0.5F;
    return {left + (right - left) * std::clamp(share, 0.0F, 1.0F), widget.center_px().y};
}

}  // namespace

base::Result<const Widget*> ScriptPlayer::find(const ScriptStep& step, const Ui& ui) const {
    const std::string& name = step.words.front();
    if (const auto found = ui.widgets.find(name); found != ui.widgets.end()) return &found->second;
    if (waited_ < patience) return nullptr;
    std::vector<std::string> names;
    for (const auto& [key, widget] : ui.widgets) names.push_back(key);
    return failed(step, "no widget of this name is shown", name, base::suggestion(name, names));
}

void ScriptPlayer::click(Input& input) {
    input.mouse_px = widget_.center_px();
    // Hovered, pressed, let go, and a frame for what it leads to.
    input.buttons[0] = frame_ == 1;
    if (++frame_ == 4) done();
}

base::Status ScriptPlayer::drag(const ScriptStep& step, Input& input) {
    if (frame_ <= 1) {
        const auto x = base::parse_number(step.words[1]);
        const auto y = step.words.size() > 2 ? base::parse_number(step.words[2]) : 0.0;
        if (!x || !y) return failed(step, "not a number", step.words[1], "drag LABEL X [Y]");
        from_px_ = widget_.center_px();
        to_px_ = widget_.range
                     ? place_of(widget_, static_cast<float>(*x))
                     : from_px_ + math::Vec2(static_cast<float>(*x), static_cast<float>(*y));
    }
    const float share =
        frame_ < 2
            ? 0.0F
            : std::min(1.0F, static_cast<float>(frame_ - 1) / static_cast<float>(drag_frames));
    input.mouse_px = from_px_ + (to_px_ - from_px_) * share;
    input.buttons[0] = frame_ >= 1 && frame_ <= drag_frames + 1;
    if (++frame_ == drag_frames + 4) done();
    return {};
}

base::Status ScriptPlayer::press(const ScriptStep& step, Input& input) {
    for (const std::string_view part : base::split(step.words.front(), '+')) {
        const int key = key_by_name(part);
        if (key == 0)
            return failed(step, "no such key", std::string(part),
                          "ctrl, shift, alt, a, 1, f1, left, enter, ...");
        input.keys[static_cast<std::size_t>(key)] = frame_ == 0;
        input.typed_keys[static_cast<std::size_t>(key)] = frame_ == 0;
    }
    if (++frame_ == 2) done();
    return {};
}

base::Status ScriptPlayer::play_step(const ScriptStep& step, Input& input, const Ui& ui,
                                     const PlayProgress& progress, const Act& act) {
    if (step.verb == Verb::click || step.verb == Verb::drag) {
        // Once more when it is pressed: what came before may still have moved it.
        if (frame_ <= 1) {
            const auto found = find(step, ui);
            if (!found) return tl::unexpected(found.error());
            if (*found == nullptr && frame_ == 0) return ++waited_, base::Status{};
            if (*found != nullptr) widget_ = **found;
        }
        if (step.verb == Verb::drag) return drag(step, input);
        click(input);
        return {};
    }
    if (step.verb == Verb::key) return press(step, input);
    if (step.verb == Verb::type) {
        for (const char c : base::join(step.words, " "))
            input.text.push_back(static_cast<char32_t>(static_cast<unsigned char>(c)));
        done();
        return {};
    }
    if (step.verb == Verb::wait) {
        const auto count = step.words.empty() ? std::optional<long long>()
                                              : base::parse_integer(step.words.front());
        ++frame_;
        // At least two frames: one takes the change over, the next can say that it is finished.
        const bool over = step.words.empty()
                              ? progress.picture_finished && frame_ > 2
                              : frame_ >= static_cast<std::size_t>(count.value_or(1));
        if (over) done();
        return {};
    }
    if (step.verb == Verb::truth) {
        const auto samples = base::parse_number(step.words.front());
        if (!samples) return failed(step, "not a number", step.words.front(), "truth 64");
        if (progress.reference_samples >= *samples && progress.is_compared) done();
        return {};
    }
    auto acted = act(step);
    done();
    return acted;
}

base::Status ScriptPlayer::play(Input& input, const Ui& ui, const PlayProgress& progress,
                                const Act& act) {
    if (is_done()) return {};
    const ScriptStep step = steps_[next_];
    return play_step(step, input, ui, progress, act);
}

}  // namespace facet::studio
