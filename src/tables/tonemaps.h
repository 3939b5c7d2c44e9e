// The tone curves: tonemaps.def's only expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace facet::tables {

enum class Tonemap {
#define TONEMAP(name, key, help) name,
#include "tables/tonemaps.def"
};
struct TonemapRow {
    std::string_view key;
    std::string_view help;
};
inline constexpr auto tonemaps = std::to_array<TonemapRow>({
#define TONEMAP(name, key, help) {key, help},
#include "tables/tonemaps.def"
});

}  // namespace facet::tables
