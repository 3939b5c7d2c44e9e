// Where the program may keep what it can compute again.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"

#include <filesystem>

namespace facet::base {

/// `facet` below $XDG_CACHE_HOME, else below ~/.cache; empty where neither is an absolute path, or
/// where $FACET_CACHE is "off". It need not be there.
[[nodiscard]] std::filesystem::path cache_folder();

/// Errors: usage, where $FACET_CACHE is neither on nor off.
[[nodiscard]] Status check_cache_variable();

/// One where nothing is kept though nobody asked for that.
[[nodiscard]] Warnings missing_cache_folder();

}  // namespace facet::base
