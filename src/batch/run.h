// Renders what is left to do of a job, on worker processes; nothing that is done is lost.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "base/progress.h"
#include "batch/job.h"
#include "batch/result.h"

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace facet::batch {

struct RunOptions {
    Shard shard;
    std::size_t jobs = 0;    ///< worker processes; 0: one a core
    unsigned threads = 0;    ///< of each; 0: the cores divided among them
    bool restart = false;    ///< forgets what was done
    bool fail_fast = false;  ///< ends after the first failure
    unsigned retries = 1;    ///< of items whose worker died, or that ask for it (exit code 70, 75)
    double item_timeout_s = 0.0;            ///< 0: none
    std::chrono::milliseconds patience{0};  ///< for other runs of the job to end
    base::Limits limits;
    std::string program;  ///< its version
    base::LogLevel level = base::LogLevel::off;
    base::Progress progress;
    /// Hears of every item as it ends, once that is recorded.
    std::function<void(const Json&)> on_item;
};

struct Outcome {
    std::size_t total = 0;    ///< of the shard
    std::size_t done = 0;     ///< by this run
    std::size_t skipped = 0;  ///< done before
    std::size_t failed = 0;
    std::size_t deaths = 0;  ///< of workers
    std::size_t workers = 0;
    double seconds = 0.0;
    int signal = 0;  ///< that ended it early
    base::Warnings warnings;
};

/// Errors: temporary (locked, disk full, no process), input_invalid (results of another job, a
/// folder that cannot be written), no_backend. Failed items are none.
[[nodiscard]] base::Result<Outcome> run(const Job& job, const RunOptions& options);

}  // namespace facet::batch
