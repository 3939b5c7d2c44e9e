// Which item comes next.
// SPDX-License-Identifier: MIT
#include "batch/queues.h"

#include <algorithm>
#include <string_view>

namespace facet::batch {

Queues::Queues(const Job& job, std::span<const std::size_t> items)
    : queues_(1), size_(items.size()) {
    std::string_view scene;
    for (const std::size_t item : items) {
        const std::string_view own = job.scene_of(item);
        if (queues_.size() == 1 || own != scene) queues_.emplace_back();
        scene = own;
        queues_.back().items.push_back(item);
    }
}

std::optional<std::size_t> Queues::next(std::size_t& queue) {
    if (size_ == 0) return std::nullopt;
    if (queues_[queue].items.empty()) {
        const auto free = std::ranges::find_if(
            queues_, [](const Queue& q) { return !q.is_taken && !q.items.empty(); });
        queue = static_cast<std::size_t>(free - queues_.begin());
        if (free == queues_.end()) {
            // The later half: the other one's next item stays with it.
            const auto longest = std::ranges::max_element(
                queues_, {}, [](const Queue& q) { return q.items.size(); });
            Queue half;
            const std::size_t count = (longest->items.size() + 1) / 2;
            const auto from = longest->items.end() - static_cast<std::ptrdiff_t>(count);
            half.items.assign(from, longest->items.end());
            longest->items.erase(from, longest->items.end());
            queues_.push_back(std::move(half));
        }
        queues_[queue].is_taken = true;
    }
    const std::size_t item = queues_[queue].items.front();
    queues_[queue].items.pop_front();
    --size_;
    return item;
}

void Queues::put_back(std::size_t queue, std::size_t item) {
    queues_[queue].items.push_front(item);
    queues_[queue].is_taken = true;
    ++size_;
}

void Queues::clear() {
    for (Queue& queue : queues_) queue.items.clear();
    size_ = 0;
}

}  // namespace facet::batch
