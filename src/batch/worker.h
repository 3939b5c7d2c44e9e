// A worker: a process of its own that renders items as it is told.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/log.h"
#include "batch/job.h"

#include <cstddef>
#include <string>

namespace facet::batch {

struct WorkerInputs {
    const Job& job;
    std::string program;  ///< its version, for results
    unsigned thread_count = 1;
    std::size_t asset_bytes = 0;
    base::Limits limits;
    base::LogLevel level = base::LogLevel::off;
};

/// The life of a worker, in its own process: reads numbers of items, one a line, from `commands`
/// until that ends, and writes a result line for each to `results`. What is decoded next, drawn and
/// written overlap; an error fails its item alone.
void work(const WorkerInputs& in, int commands, int results);

}  // namespace facet::batch
