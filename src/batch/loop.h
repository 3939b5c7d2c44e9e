// The loop around the workers: gives items out, hears of them, writes down what became of each.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/run.h"
#include "batch/state.h"
#include "batch/worker.h"

#include <span>

namespace facet::batch {

struct LoopInputs {
    const Job& job;
    const RunOptions& options;
    std::span<const std::size_t> items;
    const WorkerInputs& worker;
};

/// Renders the items on `outcome.workers` processes; fills done, failed and signal. Ends when all
/// have ended, or soon after a signal. Errors: temporary (no process, disk full), no_backend.
[[nodiscard]] base::Status render_items(const LoopInputs& in, ResultsFile& results,
                                        Outcome& outcome);

}  // namespace facet::batch
