// What the rows of the tables say about themselves; CLI, JSON, checks and docs loop over these.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace facet::tables {

/// Closed interval of allowed values.
struct Range {
    double low = 0.0;
    double high = 1.0;
};

/// What a colour's numbers mean.
enum class Space { none, linear_rec709, srgb };

}  // namespace facet::tables
