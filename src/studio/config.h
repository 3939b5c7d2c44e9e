// What the studio remembers between sessions: in XDG_CONFIG_HOME/facet/studio.json.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"
#include "studio/theme.h"

#include <filesystem>
#include <string>
#include <vector>

namespace facet::studio {

/// Panels' sizes, in points of the design.
struct Layout {
    float left = 270.0F;
    float right = 350.0F;
    float bottom = 226.0F;
    bool operator==(const Layout&) const = default;
};

struct Config {
    Theme theme = Theme::dark;
    std::string language;  ///< empty: the desktop's
    math::Extent window_points{1440, 860};
    Layout layout;
    std::vector<std::string> recent;  ///< scenes, newest first
    bool operator==(const Config&) const = default;

    void remember(const std::string& scene);
};

/// Of the XDG base directory specification; empty where there is neither the variable nor a home.
[[nodiscard]] std::filesystem::path config_folder();
[[nodiscard]] std::filesystem::path state_folder();
/// What can be read of it; the rest is as it is initially.
[[nodiscard]] Config load_config();
/// Fails silently: a read-only home is no reason to stop.
void save_config(const Config& config);
/// "ru" where the desktop's locale says so, else "en".
[[nodiscard]] std::string desktop_language();

}  // namespace facet::studio
