// The panels: each draws itself into the window that ImGui has open, reads the stage and changes
// the editor. SPDX-License-Identifier: MIT
#pragma once

#include "studio/editor.h"
#include "studio/inspection.h"
#include "studio/lesson.h"
#include "studio/stage.h"
#include "studio/ui.h"

namespace facet::studio {

class Thumbnails;

/// What every panel gets.
struct PanelTools {
    Ui& ui;
    Editor& editor;
    const Stage& stage;
    const gl::Context& gl;
    const Inspection& inspection;
    const Thumbnails& thumbnails;
    const std::optional<StudioLesson>& lesson;
};

void draw_material_panel(PanelTools& tools);
void draw_scene_panel(PanelTools& tools);
/// Precondition: there is a lesson.
void draw_lesson(PanelTools& tools);

}  // namespace facet::studio
