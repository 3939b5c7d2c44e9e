// The program from its arguments to its exit status.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io.h"

#include <span>
#include <string>

namespace facet::cli {

/// Reads the arguments (without the program's name), does what they ask for, and returns the exit
/// status. `environment` is environ: FACET_* variables that nothing reads are warned about.
[[nodiscard]] int run_program(std::span<const std::string> arguments, char** environment, Io& io);

}  // namespace facet::cli
