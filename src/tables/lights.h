// The kinds of light and their values: light_kinds.def's and light_keys.def's only expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include "tables/describe.h"

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

enum class LightKeyType { number, vector, color, toggle, text };

/// One row of light_keys.def.
struct LightKeyRow {
    std::string_view key;
    LightKeyType type = LightKeyType::number;
    Range range{};
    Range slider{0, 0};        ///< what a slider spans, where that is less than `range`
    bool logarithmic = false;  ///< slider
    std::string_view unit = {};
    bool write_only = false;  ///< changes another key's value
    std::string_view help;
};
inline constexpr auto light_keys = std::to_array<LightKeyRow>({
#define LIGHT_KEY(name, ...) {.key = #name, __VA_ARGS__},
#include "tables/light_keys.def"
});
/// The row of a key that there is.
[[nodiscard]] constexpr const LightKeyRow& light_key(std::string_view key) {
    for (const LightKeyRow& row : light_keys)
        if (row.key == key) return row;
    return light_keys.front();
}

}  // namespace facet::tables
