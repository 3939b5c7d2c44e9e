// The tables of a data set: where each picture was taken from, and what its numbers mean.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/thread_pool.h"
#include "batch/job.h"

#include <vector>

namespace facet::batch {

/// Writes into the job's data-set folder, from what is done of its items:
/// - `manifest.jsonl`: one line an item, with its files, camera, exposure and settings;
/// - `transforms.json`: the perspective ones in NeRF's form (Mildenhall et al. 2020; keys as
///   instant-ngp reads them);
/// - `names.json`: by scene, the names behind object_id and material_id.
/// Conventions: docs/batch.md. Errors: those of writing.
[[nodiscard]] base::Status write_data_set(const Job& job, const std::vector<Json>& results,
                                          const base::Limits& limits, base::ThreadPool& pool);

}  // namespace facet::batch
