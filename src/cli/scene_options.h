// The settings that concern the reading of a scene, for the commands that read one without
// rendering it. SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "cli/setting_flags.h"
#include "scene/load.h"

namespace facet::cli {

/// Whether a row is about reading a scene: what may be read, and how much.
[[nodiscard]] bool concerns_loading(const tables::Setting& row);
[[nodiscard]] scene::LoadOptions load_options(const tables::Settings& settings);
[[nodiscard]] base::Limits limits_of(const tables::Settings& settings);

}  // namespace facet::cli
