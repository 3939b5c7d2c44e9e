// Reading a job file.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "batch/job.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace facet::batch {

/// Everything found wrong with a job file in one run.
struct JobProblems {
    std::vector<base::Error> errors;
    base::Warnings warnings;
};

struct JobOptions {
    tables::Settings settings;  ///< from the command line: what every item begins with
    base::Limits limits;
};

/// The job that `text` describes; paths in it are relative to the folder of `file`, and stay in it
/// or in the settings' allow_read. Nothing where there are errors: input_invalid (with JSON
/// pointer, line and column), limit_reached, usage (no items).
[[nodiscard]] std::optional<Job> parse_job(std::string_view text, const std::filesystem::path& file,
                                           const JobOptions& options, JobProblems& problems);

/// Likewise from the file itself.
[[nodiscard]] std::optional<Job> read_job(const std::filesystem::path& file,
                                          const JobOptions& options, JobProblems& problems);

/// The keys of settings that an item may have.
[[nodiscard]] bool is_job_key(const tables::Setting& row);

}  // namespace facet::batch
