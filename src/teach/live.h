// The canvas of a page: the program's own shader text for WebGL 2, and what its controls are.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/texts.h"
#include "teach/lesson.h"

#include <string>

namespace facet::teach {

/// A JSON object for resources/teach/live.js: shaders, sliders, switches, models, views, words.
/// Errors: internal (a shader file is missing).
[[nodiscard]] base::Result<Json> live_config(const Live& live, const base::Texts& texts);

}  // namespace facet::teach
