// What is known of every item of a job, whichever run or shard rendered it.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/state.h"

#include <vector>

namespace facet::batch {

/// The last result of each of `items`, in their order; null where there is none. With
/// `check_outputs` null also where the output is not as it was written, or the job or its inputs
/// changed since. Errors: as read_results().
[[nodiscard]] base::Result<std::vector<Json>> collect(const Job& job,
                                                      const std::vector<std::size_t>& items,
                                                      const Shard& shard, bool check_outputs,
                                                      const base::Limits& limits);

struct Merged {
    std::size_t total = 0;
    std::size_t done = 0;
    std::vector<std::size_t> missing;  ///< never rendered, or not as the job has it now
    std::vector<Json> failed;
    std::filesystem::path file;  ///< all results, one an item in the job's order
};
/// Joins the results of all shards into JOB.facet/results.jsonl. Errors: as read_results(), and
/// those of writing.
[[nodiscard]] base::Result<Merged> merge(const Job& job, const base::Limits& limits);

}  // namespace facet::batch
