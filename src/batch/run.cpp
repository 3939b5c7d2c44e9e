// Renders what is left to do of a job, on worker processes.
// SPDX-License-Identifier: MIT
#include "batch/run.h"

#include "batch/input_hash.h"
#include "batch/leftovers.h"
#include "batch/lock.h"
#include "batch/loop.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <thread>

namespace facet::batch {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr std::size_t most_jobs = 256;
constexpr std::size_t asset_bytes = std::size_t{48} << 20U;  // of a worker's 400 MB

/// Of `items` those that are still to be rendered.
base::Result<std::vector<std::size_t>> items_left(const Job& job, std::vector<std::size_t> items,
                                                  const RunOptions& options) {
    if (options.restart) return items;
    const auto done = read_done(job, options.shard, options.limits);
    if (!done) return tl::unexpected(done.error());
    if (done->empty()) return items;
    InputHashes hashes(options.limits);
    std::erase_if(items, [&](std::size_t index) {
        const auto record = done->find(recorded_path(job, job.output_of(index)));
        if (record == done->end()) return false;
        const auto item = job.item(index);
        return item && record->second.program == options.program &&
               holds(job, record->second, hashes.of(job, *item));
    });
    return items;
}

base::Status make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (!error) return {};
    return base::fail({.code = error == std::errc::no_space_on_device ? ErrorCode::temporary
                                                                      : ErrorCode::input_invalid,
                       .file = folder.string(),
                       .what = "cannot be made: " + error.message()});
}

}  // namespace

base::Result<Outcome> run(const Job& job, const RunOptions& options) {
    const auto start = Clock::now();
    Outcome outcome;
    if (auto made = make_folder(state_folder(job)); !made) return tl::unexpected(made.error());
    const auto lock =
        ShardLock::take(state_folder(job), options.shard, options.patience, outcome.warnings);
    if (!lock) return tl::unexpected(lock.error());
    const std::vector<std::size_t> all = items_of(job, options.shard);
    const auto items = items_left(job, all, options);
    if (!items) return tl::unexpected(items.error());
    auto results = ResultsFile::open(job, options.shard, options.restart);
    if (!results) return tl::unexpected(results.error());
    // Of all items: one that was killed between naming and renaming may have been done since.
    remove_leftovers(job, all);
    outcome.total = all.size();
    outcome.skipped = outcome.total - items->size();
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    std::size_t jobs = options.jobs > 0 ? options.jobs : cores;
    if (jobs > most_jobs)
        outcome.warnings.push_back({.file = "--jobs",
                                    .what = fmt::format("at most {} processes", most_jobs),
                                    .found = fmt::format("{}", jobs)});
    outcome.workers = std::min({jobs, most_jobs, std::max<std::size_t>(items->size(), 1)});
    const WorkerInputs worker{.job = job,
                              .program = options.program,
                              .thread_count = options.threads > 0
                                                  ? options.threads
                                                  : static_cast<unsigned>(std::max<std::size_t>(
                                                        cores / outcome.workers, 1)),
                              .asset_bytes = asset_bytes,
                              .limits = options.limits,
                              .level = options.level};
    if (auto s = render_items({job, options, *items, worker}, *results, outcome); !s)
        return tl::unexpected(s.error());
    if (outcome.deaths > 0) remove_leftovers(job, all);
    outcome.seconds = Seconds(Clock::now() - start).count();
    return outcome;
}

}  // namespace facet::batch
