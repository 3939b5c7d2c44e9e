// Errors and warnings as JSON objects.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"

#include <nlohmann/json_fwd.hpp>

namespace facet::tables {

/// {severity, code, path, pointer, message}; the code is the name of the exit status, "warning" for
/// a warning.
[[nodiscard]] nlohmann::ordered_json message_object(const base::Error& error);
[[nodiscard]] nlohmann::ordered_json message_object(const base::Warning& warning);

}  // namespace facet::tables
