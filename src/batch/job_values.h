// What stands for a key in a job file: one value, a list that the pictures run through, or a draw.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/job.h"

#include <optional>
#include <variant>
#include <vector>

namespace facet::batch {

/// One member of an item or of the defaults.
struct Given {
    AxisKind kind = AxisKind::setting;
    std::string key;  ///< of a setting, or a path of `set`
    const Json* value = nullptr;
    std::string pointer;
};

using OneOrMore = std::variant<Json, Axis, Draw>;

/// Sorts out what `given` is: an array is an axis unless the value itself is one (a size, a vector,
/// a list of lights); {"random": ...} and a camera's {"sphere": N} are written out. Errors:
/// input_invalid (neither), with `where` a JSON pointer.
[[nodiscard]] base::Result<OneOrMore> sort_out(const Given& given);

/// What a file name or a report calls a value.
[[nodiscard]] std::string label_of(AxisKind kind, std::string_view key, const Json& value);

/// The value that `draw` gives item `index`.
[[nodiscard]] Json drawn(const Draw& draw, std::size_t index);

}  // namespace facet::batch
