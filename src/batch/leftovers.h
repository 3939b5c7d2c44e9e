// Temporary files that a run which was killed left behind.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/job.h"

#include <span>

namespace facet::batch {

/// Removes `.NAME.PID.tmp` beside the outputs of `items` where NAME is one of theirs and no process
/// PID is there. Only whoever holds their lock may call it.
void remove_leftovers(const Job& job, std::span<const std::size_t> items);

}  // namespace facet::batch
