// The further outputs: aovs.def's only expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include "tables/describe.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace facet::tables {

enum class Aov : std::size_t {
#define AOV(name, ...) name,
#include "tables/aovs.def"
};
/// How the jittered samples of a pixel become one value.
enum class Average { mean, nearest };
/// How a value becomes 0..1 in a PNG side file; `compressed` is x / (1 + x), for what has no end,
/// `exposed` the picture's exposure times x.
enum class PngCode { clamp, signed_unit, range, id_color, compressed, exposed };
/// What a value is of: the surface alone, its BRDF in the light of the key light, or the light that
/// came one way. The last kind's rows add up to the beauty.
enum class AovKind { surface, key_light, light_path };

/// One row of aovs.def.
struct AovRow {
    std::string_view key;
    std::string_view glsl;
    AovKind kind = AovKind::surface;
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
[[nodiscard]] constexpr std::optional<Aov> aov_named(std::string_view key) {
    for (std::size_t i = 0; i < aovs.size(); ++i)
        if (aovs[i].key == key) return static_cast<Aov>(i);
    return std::nullopt;
}
[[nodiscard]] inline std::vector<Aov> of_kind(std::span<const Aov> chosen, AovKind kind) {
    std::vector<Aov> out;
    for (const Aov aov : chosen)
        if (row(aov).kind == kind) out.push_back(aov);
    return out;
}
[[nodiscard]] constexpr bool any_of_kind(std::span<const Aov> chosen, AovKind kind) {
    for (const Aov aov : chosen)
        if (row(aov).kind == kind) return true;
    return false;
}

}  // namespace facet::tables
