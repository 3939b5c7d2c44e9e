// A window with a GL context, by GLFW, which is opened at run time: only a window needs it.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "gl/api.h"
#include "studio/input.h"

#include <memory>
#include <string>

namespace facet::studio {

class Window {
public:
    /// `points`: the size wanted, in points of the design. The window's context is current then.
    /// Errors: no_backend, without GLFW, a display, or a core profile of GL 4.3.
    [[nodiscard]] static base::Result<Window> open(math::Extent points, const std::string& title);
    Window(Window&&) noexcept;
    Window& operator=(Window&&) noexcept;
    ~Window();

    /// Takes in what happened; where nothing did, waits for it, `wait_s` at most (0: not at all).
    void poll(Input& input, double wait_s);
    /// Shows what was drawn into framebuffer 0.
    void swap();
    /// Ends a waiting poll(); from any thread.
    void wake() const;
    void set_title(const std::string& title);
    [[nodiscard]] gl::Loader loader() const;
    /// Makes ImGui's copying and pasting the desktop's.
    void share_clipboard();

private:
    struct Glfw;
    struct Impl;
    explicit Window(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace facet::studio
