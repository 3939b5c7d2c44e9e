// Which build of the program this is.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace facet::base {

/// The linker's build id of the running program in hexadecimal digits: another one for other code.
/// Empty where the linker left none.
[[nodiscard]] std::string build_id();

}  // namespace facet::base
