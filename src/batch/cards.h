// Finished pictures made small, and compared with earlier ones: what a report shows.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "base/thread_pool.h"
#include "batch/job.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace facet::batch {

struct Card {
    std::size_t item = 0;
    Json result;  ///< null: never rendered
    // Pictures for a page, as data URIs; empty where there is none.
    std::string picture;
    std::string baseline;
    std::string heat;               ///< where the two differ
    std::optional<double> flip;     ///< mean, against the baseline
    std::filesystem::path earlier;  ///< the baseline's file, where there is one
    std::string problem;            ///< why there is no picture, or no comparison
};

struct CardOptions {
    std::optional<std::filesystem::path> baseline;  ///< folder, with the paths of the outputs in it
    bool with_pictures = true;
    std::uint32_t side_px = 256;  ///< at most, of a thumbnail
    base::Progress progress;
};

/// One card an item. Reads the outputs; what cannot be read becomes the card's problem.
[[nodiscard]] std::vector<Card> make_cards(const Job& job, const std::vector<std::size_t>& items,
                                           std::vector<Json> results, const CardOptions& options,
                                           base::ThreadPool& pool);

}  // namespace facet::batch
