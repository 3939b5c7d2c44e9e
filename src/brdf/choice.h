// The value of --brdf: text to a choice of terms.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "tables/brdf_terms.h"

#include <string_view>

namespace facet::brdf {

/// What the choice is for: some terms exist for lessons and `facet brdf` only.
enum class Use { render, lesson };

/// `slot=term,…` (`,` or `;` between, dashes or underscores in names), `lecture`, for lessons
/// `lecture-literal`, or nothing for the default model. Errors: usage, with the nearest right
/// names.
[[nodiscard]] base::Result<tables::BrdfChoice> parse_choice(std::string_view text, Use use);

}  // namespace facet::brdf
