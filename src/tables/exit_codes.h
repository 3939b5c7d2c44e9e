// The exit statuses: exit_codes.def's only expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace facet::tables {

enum class Exit : int {
#define EXIT(name, status, ...) name = status,
#include "tables/exit_codes.def"
};

/// One row of exit_codes.def.
struct ExitRow {
    std::string_view key;  ///< also the code of the message in JSON
    int number = 0;
    std::string_view help;
};
inline constexpr auto exit_codes = std::to_array<ExitRow>({
#define EXIT(name, status, ...) {.key = #name, .number = status, __VA_ARGS__},
#include "tables/exit_codes.def"
});

/// The name of a status; "internal" for a number that is in no row.
[[nodiscard]] constexpr std::string_view exit_name(int number) noexcept {
    for (const ExitRow& row : exit_codes)
        if (row.number == number) return row.key;
    return "internal";
}

}  // namespace facet::tables
