// The form of a job file as a JSON Schema, for editors: written from the tables that read it.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/job.h"

namespace facet::batch {

/// Draft 7, which editors know. What it cannot say (paths, placeholders, what excludes what) is the
/// reader's to check; what the reader takes it never refuses.
[[nodiscard]] Json job_schema();

}  // namespace facet::batch
