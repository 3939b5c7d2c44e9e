// The kinds of light: light_kinds.def's only expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace facet::tables {

enum class LightKind {
#define LIGHT(name, ...) name,
#include "tables/light_kinds.def"
};

/// One row of light_kinds.def. `keys`: comma list of what --light takes for this kind.
struct LightKindRow {
    std::string_view key;
    std::string_view unit;  ///< of Light::intensity
    std::string_view keys;
    bool area = false;  ///< has a size
    std::string_view help;
};
inline constexpr auto light_kinds = std::to_array<LightKindRow>({
#define LIGHT(name, ...) {.key = #name, __VA_ARGS__},
#include "tables/light_kinds.def"
});

}  // namespace facet::tables
