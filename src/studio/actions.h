// Everything the menus do, with its keys: one list for menus, keyboard and help.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace facet::studio {

enum class Action {
#define ACTION(name, menu, keys) name,
#include "studio/actions.def"
};

struct ActionRow {
    std::string_view name;  ///< its text is "studio.NAME"
    std::string_view menu;
    std::string_view keys;
};
inline constexpr auto actions = std::to_array<ActionRow>({
#define ACTION(name, menu, keys) {#name, #menu, keys},
#include "studio/actions.def"
});

/// The action whose keys were pressed in this frame of ImGui; none while a text field has them.
[[nodiscard]] std::optional<Action> pressed_action();
/// "Ctrl+Shift+S".
[[nodiscard]] std::string shown_keys(std::string_view keys);

}  // namespace facet::studio
