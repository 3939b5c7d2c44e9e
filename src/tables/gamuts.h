// The colours of a picture's file: gamuts.def's only expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace facet::tables {

enum class Gamut : std::uint8_t {
#define GAMUT(name, key, ...) name,
#include "tables/gamuts.def"
};
struct GamutRow {
    std::string_view key;
    std::uint8_t primaries = 1;
    std::uint8_t transfer = 13;
    std::string_view help;
};
inline constexpr auto gamuts = std::to_array<GamutRow>({
#define GAMUT(name, text, ...) {.key = text, __VA_ARGS__},
#include "tables/gamuts.def"
});
[[nodiscard]] constexpr const GamutRow& row(Gamut gamut) {
    return gamuts[static_cast<std::size_t>(gamut)];
}

}  // namespace facet::tables
