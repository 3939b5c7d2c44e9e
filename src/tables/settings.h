// The settings of one picture: settings.def's only expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"
#include "tables/describe.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace facet::tables {

using math::Extent;
using Text = std::string;
using Number = float;
using OptionalNumber = std::optional<float>;
using Count = std::uint32_t;
using Flag = bool;
using List = std::vector<std::string>;  ///< comma-separated on the command line unless repeatable

struct Settings {
#define SETTING(type, name, initial, ...) type name = initial;
#include "tables/settings.def"
    bool operator==(const Settings&) const = default;
};

/// One row of settings.def.
struct Setting {
    std::string_view key;
    std::variant<Extent Settings::*, Text Settings::*, Number Settings::*,
                 OptionalNumber Settings::*, Count Settings::*, Flag Settings::*, List Settings::*>
        field;
    Range range{};
    Range slider{0, 0};           ///< what a slider spans, where that is less than `range`
    bool logarithmic = false;     ///< slider
    std::string_view value = {};  ///< what stands for the value in help
    std::string_view group;
    bool repeatable = false;
    bool rare = false;  ///< left out of --help
    std::string_view help;
};
inline constexpr auto settings = std::to_array<Setting>({
#define SETTING(type, name, initial, ...) {.key = #name, .field = &Settings::name, __VA_ARGS__},
#include "tables/settings.def"
});

}  // namespace facet::tables
