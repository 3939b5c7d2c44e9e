// The further outputs: aovs.def's only expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include "tables/describe.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace facet::tables {

enum class Aov : std::size_t {
#define AOV(name, ...) name,
#include "tables/aovs.def"
};
/// How the jittered samples of a pixel become one value.
enum class Average { mean, nearest };
/// How a value becomes 0..1 in a PNG side file.
enum class PngCode { clamp, signed_unit, range, id_color };

/// One row of aovs.def.
struct AovRow {
    std::string_view key;
    std::string_view glsl;
    std::string_view channels;  ///< EXR channel letters
    Space space = Space::none;
    Average average = Average::mean;
    PngCode png = PngCode::clamp;
    std::string_view help;
};
inline constexpr auto aovs = std::to_array<AovRow>({
#define AOV(name, value, ...) {.key = #name, .glsl = #value, __VA_ARGS__},
#include "tables/aovs.def"
});
[[nodiscard]] constexpr const AovRow& row(Aov aov) { return aovs[static_cast<std::size_t>(aov)]; }

}  // namespace facet::tables
