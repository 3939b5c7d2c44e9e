// facet check --capabilities: what this build reads, shows and writes.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io.h"

namespace facet::cli {

/// A line for each kind of thing, or one object with --json.
void print_capabilities(Io& io);

}  // namespace facet::cli
