// What the studio is drawn on: a window, or a picture in memory.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "gl/context.h"
#include "gl/objects.h"
#include "image/image.h"
#include "studio/input.h"
#include "studio/window.h"

#include <optional>

namespace facet::studio {

class Screen {
public:
    /// `points`: the size wanted. Errors: no_backend.
    [[nodiscard]] static base::Result<Screen> open_window(math::Extent points, base::Log& log);
    [[nodiscard]] static base::Result<Screen> open_offscreen(math::Extent size_px,
                                                             gl::Backend backend, base::Log& log);
    [[nodiscard]] const gl::Context& gl() const { return *gl_; }
    [[nodiscard]] Window* window() { return window_ ? &*window_ : nullptr; }
    /// What a person does; waits `wait_s` at most where nothing happens. Offscreen nobody does
    /// anything.
    void poll(Input& input, double wait_s);
    /// Where to draw, cleared to `gray`. Errors: limit_reached.
    [[nodiscard]] base::Result<GLuint> begin(math::Extent size_px, float gray);
    void show();
    /// What was drawn since begin(), before show(): RGBA, rows from the top.
    [[nodiscard]] image::Image read() const;

private:
    // Declared first, so that they die last.
    std::optional<Window> window_;
    std::optional<gl::Context> gl_;
    math::Extent size_px_;
    gl::Texture color_;
    gl::Framebuffer framebuffer_;
};

}  // namespace facet::studio
