// Which item comes next: those of one scene stay with the worker that has it.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/job.h"

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace facet::batch {

/// Items that wait, in a queue for each scene. A taker works through one queue; when no other is
/// left untaken it takes over half of the longest.
class Queues {
public:
    Queues(const Job& job, std::span<const std::size_t> items);

    [[nodiscard]] std::size_t size() const { return size_; }
    /// The next item for the taker whose queue is `queue`, which is changed to the one that the
    /// item came from.
    [[nodiscard]] std::optional<std::size_t> next(std::size_t& queue);
    /// Back to the front of its queue.
    void put_back(std::size_t queue, std::size_t item);
    void clear();

private:
    struct Queue {
        std::deque<std::size_t> items;
        bool is_taken = false;
    };
    std::vector<Queue> queues_;  ///< number 0 stays empty: no queue
    std::size_t size_ = 0;
};

}  // namespace facet::batch
