// The small language of options: `key=value,…`, vectors, colours and numbers in a range.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "math/vector.h"
#include "tables/describe.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facet::scene {

/// One `key=value`; dashes of the key are read as underscores.
struct KeyValue {
    std::string key;
    std::string value;
};
/// Errors: usage (a part without `=`, a key that stands twice).
[[nodiscard]] base::Result<std::vector<KeyValue>> parse_key_values(std::string_view text);

/// Errors of all below: usage, naming `key`, what was found and what it takes.
[[nodiscard]] base::Result<float> parse_in_range(std::string_view key, std::string_view value,
                                                 const tables::Range& range);
/// `x y z`, each within `range`.
[[nodiscard]] base::Result<math::Vec3> parse_vector(std::string_view key, std::string_view value,
                                                    const tables::Range& range);
/// `#rrggbb` in sRGB, or `r g b` linear, each within `range`; linear Rec.709.
[[nodiscard]] base::Result<math::Vec3> parse_color(std::string_view key, std::string_view value,
                                                   const tables::Range& range);

/// "did you mean A, B" of the nearest names, and what there is: "there is A, B, C".
[[nodiscard]] std::string suggestion(std::string_view name, std::span<const std::string> names);

[[nodiscard]] tl::unexpected<base::Error> usage_error(std::string what, std::string_view found,
                                                      std::string remedy);

}  // namespace facet::scene
