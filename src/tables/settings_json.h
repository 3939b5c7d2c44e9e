// The settings of a picture as JSON has them: the keys of job files and lessons.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "tables/settings.h"

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace facet::tables {

/// Sets one setting from its JSON value: a number, a text, true or false; `size` as "WxH" or [W,
/// H]; lists as arrays of texts; `set` as {"PATH": value}, a vector as [x, y, z], laid over what
/// `set` holds already. Errors: usage, with the key and what it takes.
[[nodiscard]] base::Status assign_json(Settings& values, std::string_view key,
                                       const nlohmann::ordered_json& value);

}  // namespace facet::tables
