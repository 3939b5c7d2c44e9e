// Where the program's own data lies: glsl/ and resources/, beside the build tree or the install
// prefix. SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"

#include <filesystem>

namespace facet::base {

/// The folder that holds `glsl/` and `resources/`. Looked for from the running program's own place,
/// never from the current directory: PREFIX/bin/facet -> PREFIX/share/facet, build/facet -> the
/// source tree. Errors: internal when neither is there.
[[nodiscard]] Result<std::filesystem::path> data_folder();

/// The folder of the running program; where its modules (shared objects opened at need) lie too, or
/// in
/// ../lib/facet of it.
[[nodiscard]] std::filesystem::path program_folder();

}  // namespace facet::base
