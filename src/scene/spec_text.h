// What --light, --set and --camera share: vectors, colours and bounded numbers as text, and their
// errors. SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "math/vector.h"
#include "tables/describe.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace facet::scene {

inline constexpr double largest_coordinate_m =
    1e9;  ///< beyond, squares of distances leave float's range

/// A ready ErrorCode::usage.
[[nodiscard]] tl::unexpected<base::Error> usage(std::string what, std::string_view found,
                                                std::string remedy);

/// `did you mean A or B; one of …`: the nearest of `names` first, then all that fit in a line.
[[nodiscard]] std::string offer(std::string_view name, std::span<const std::string> names);

/// Three finite numbers with spaces between, `x y z`; nothing where one lies outside `range`.
[[nodiscard]] std::optional<math::Vec3> parse_vector(std::string_view text,
                                                     tables::Range range = {-largest_coordinate_m,
                                                                            largest_coordinate_m});

/// A number within `range`. Errors: usage, naming `key`, the range and the unit (may be empty).
[[nodiscard]] base::Result<float> parse_bounded(std::string_view key, std::string_view text,
                                                tables::Range range, std::string_view unit);

/// `#rrggbb` (sRGB) or `r g b` (linear, within `range`) as linear Rec.709. Errors: usage, naming
/// `key`.
[[nodiscard]] base::Result<math::Vec3> parse_color(std::string_view key, std::string_view text,
                                                   tables::Range range = {0, 1});

}  // namespace facet::scene
