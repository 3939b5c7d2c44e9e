// Keeps the inspection true of what is shown, and picks materials by a click.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/editor.h"
#include "studio/inspection.h"
#include "studio/ui_renderer.h"

namespace facet::studio {

class Prober {
public:
    /// Once a frame, after the stage's step: histogram and clipping of a new picture, facts of the
    /// pixel under the mouse.
    void update(const gl::Context& gl, Stage& stage, Editor& editor, UiRenderer& pictures,
                Inspection& inspection);

private:
    void look_at_picture(const gl::Context& gl, const Stage& stage, Editor& editor,
                         UiRenderer& pictures, Inspection& inspection);
    std::uint32_t seen_count_ = 0;  ///< the stage's pictures, when it was looked at
    std::optional<math::Vec2> probed_px_;
};

}  // namespace facet::studio
