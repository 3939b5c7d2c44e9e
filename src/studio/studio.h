// The studio: a window in which a scene's materials are edited and seen, or the same drawn without
// a display. SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "base/result.h"
#include "studio/lesson.h"
#include "studio/script.h"
#include "studio/theme.h"
#include "tables/settings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace facet::studio {

struct StudioRequest {
    std::string scene = "builtin:showcase";
    tables::Settings settings;
    bool offscreen = false;      ///< no window: the same pictures, for tests and documents
    std::uint32_t frames = 0;    ///< ends after so many; 0: when it is closed
    std::filesystem::path shot;  ///< where the last frame is written; empty: nowhere
    std::optional<StudioLesson> lesson;
    std::vector<ScriptStep> script;
    bool has_script = false;  ///< offscreen ends with it
    std::string language;     ///< empty: as it was last, or the desktop's
    std::optional<Theme> theme;
    math::Extent window_points{0, 0};  ///< none: as it was last
};

/// Runs until the window is closed, the script ends or the frames are drawn. Errors: those of the
/// scene, no_backend (no display: --offscreen needs none), usage (the script).
[[nodiscard]] base::Status run(const StudioRequest& request, base::Log& log);

}  // namespace facet::studio
