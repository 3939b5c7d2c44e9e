// What follows a batch: the data set's tables, the report, the comparison with earlier pictures.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/job.h"
#include "cli/io.h"

#include <optional>
#include <string>

namespace facet::cli {

struct ReportOptions {
    std::string report;    ///< file of the page; empty: none
    std::string baseline;  ///< folder of earlier pictures; empty: none
    std::optional<double> max_flip;
    bool merge = false;  ///< of all shards
};

/// Where pictures and pages can be compared and written, before any work begins. Errors: usage,
/// input_invalid.
[[nodiscard]] base::Status check_report(const ReportOptions& options);

/// What is made of all that is done; whether every picture is as it was.
[[nodiscard]] base::Result<bool> conclude(const ReportOptions& options, const batch::Job& job,
                                          const batch::Shard& shard, Io& io);

}  // namespace facet::cli
