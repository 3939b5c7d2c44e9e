// The files that a job writes: no two items the same one.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/job_file.h"

namespace facet::batch {

/// Adds an error for two items that would write one file, also where only letter case, `./` or a
/// link of a folder keeps them apart; and for a name that no file can have.
void check_outputs(const Job& job, JobProblems& problems);

}  // namespace facet::batch
