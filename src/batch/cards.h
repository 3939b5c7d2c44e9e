// Finished pictures made small, and compared with earlier ones: what a report shows.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "base/thread_pool.h"
#include "batch/job.h"
#include "image/image.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace facet::batch {

/// A picture for a page, as a data URI; empty where there is none.
struct Thumbnail {
    math::Extent size;
    std::string data_uri;
};

struct Card {
    std::size_t item = 0;
    Json result;  ///< null: never rendered
    Thumbnail picture;
    Thumbnail baseline;
    Thumbnail heat;                 ///< where the two differ
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
