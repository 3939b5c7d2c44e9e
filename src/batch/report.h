// A contact sheet: one page that needs nothing else, of everything a job rendered.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/cards.h"

#include <filesystem>

namespace facet::batch {

struct ReportOptions {
    std::filesystem::path file;
    double max_flip = 0.0;  ///< beyond it a picture counts as changed
    bool has_baseline = false;
};

/// Writes the page; pictures at full size are linked, by paths relative to it. Errors: those of
/// writing, internal (the page's own script is not there).
[[nodiscard]] base::Status write_report(const Job& job, const std::vector<Card>& cards,
                                        const ReportOptions& options);

}  // namespace facet::batch
