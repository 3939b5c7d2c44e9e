// What a person does with mouse and keyboard in one frame, whether a window or a script says it.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"

#include <array>
#include <bitset>
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

namespace facet::studio {

/// Keys have GLFW's numbers.
inline constexpr std::size_t key_count = 512;

struct Input {
    math::Extent window_px;         ///< of the framebuffer
    float scale = 1.0F;             ///< pixels to one point of the design
    math::Vec2 mouse_px{-1.0F};     ///< from the top left
    std::array<bool, 3> buttons{};  ///< left, right, middle
    float wheel = 0.0F;
    std::bitset<key_count> keys;
    std::bitset<key_count> typed_keys;  ///< went down since the last frame, repeats too
    std::u32string text;
    std::vector<std::filesystem::path> dropped;
    bool wants_close = false;

    /// Forgets what only this frame brought.
    void next_frame() {
        wheel = 0.0F;
        typed_keys.reset();
        text.clear();
        dropped.clear();
    }
    [[nodiscard]] bool is_idle() const {
        return buttons == std::array<bool, 3>{} && wheel == 0.0F && typed_keys.none() &&
               keys.none() && text.empty() && dropped.empty();
    }
};

/// What a mouse did between two frames. Each press and release gets a frame of its own, in order
/// and where it happened: slow frames lose no click, and no end of a drag.
class MouseQueue {
public:
    /// A button (left, right, middle) went down or up.
    void push(std::size_t button, bool is_down, math::Vec2 at_px) {
        events_.push_back({button, is_down, at_px});
    }
    void clear() { events_.clear(); }
    [[nodiscard]] bool is_empty() const { return events_.empty(); }
    /// Sets the mouse of the next frame. `now_px`: where it is once all has been told.
    void advance(Input& input, math::Vec2 now_px);

private:
    struct Event {
        std::size_t button = 0;
        bool is_down = false;
        math::Vec2 at_px{};
    };
    std::deque<Event> events_;
};

/// Hands the input to ImGui. `delta_s`: since the last frame, above 0.
void feed_imgui(const Input& input, float delta_s);
/// Tells ImGui which number each key has.
void map_keys();
/// The number of a key by its name ("ctrl", "z", "f1", "left"); 0 where there is none.
[[nodiscard]] int key_by_name(std::string_view name);

}  // namespace facet::studio
