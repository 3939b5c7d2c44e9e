// The computed environments: environments.def's only expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace facet::tables {

enum class EnvironmentKind {
#define ENVIRONMENT(name, ...) name,
#include "tables/environments.def"
};
/// One row of environments.def. `keys`: comma list of parameters it takes.
struct EnvironmentRow {
    std::string_view key;
    std::string_view keys = {};
    std::string_view help = {};
};
inline constexpr auto environments = std::to_array<EnvironmentRow>({
#define ENVIRONMENT(name, ...) {.key = #name, __VA_ARGS__},
#include "tables/environments.def"
});

}  // namespace facet::tables
