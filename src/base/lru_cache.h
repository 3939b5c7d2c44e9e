// Things kept for the next one who asks, within a bound of memory.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace facet::base {

/// Values by name. Above the bound the one that was not asked for longest goes, but for the last
/// two: what is worked on and what comes next. Whoever still holds a value keeps it alive. Safe to
/// use from several threads.
template <class Value>
class LruCache {
public:
    explicit LruCache(std::size_t max_bytes) : max_bytes_(max_bytes) {}

    /// Null where there is none of this name.
    [[nodiscard]] std::shared_ptr<const Value> find(std::string_view name) {
        const std::lock_guard lock(mutex_);
        for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
            if (entry->name != name) continue;
            entries_.splice(entries_.begin(), entries_, entry);
            return entries_.front().value;
        }
        return nullptr;
    }

    void put(std::string name, std::shared_ptr<const Value> value, std::size_t bytes) {
        const std::lock_guard lock(mutex_);
        entries_.push_front({std::move(name), std::move(value), bytes});
        bytes_ += bytes;
        while (bytes_ > max_bytes_ && entries_.size() > always_kept) {
            bytes_ -= entries_.back().bytes;
            entries_.pop_back();
        }
    }

private:
    struct Entry {
        std::string name;
        std::shared_ptr<const Value> value;
        std::size_t bytes = 0;
    };
    static constexpr std::size_t always_kept = 2;
    std::size_t max_bytes_;
    std::size_t bytes_ = 0;
    std::list<Entry> entries_;  ///< the last asked for first
    std::mutex mutex_;
};

}  // namespace facet::base
