// Work spread over the cores, in a way that the result cannot depend on how many there are.
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace facet::base {

/// A fixed set of worker threads.
class ThreadPool {
public:
    /// `thread_count` 0 means one per core; where the system refuses so many, fewer are started.
    /// The calling thread of parallel_for works too, so `thread_count`
    /// - 1 threads are started, and none for 1.
    explicit ThreadPool(unsigned thread_count = 0);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    [[nodiscard]] unsigned thread_count() const noexcept {
        return static_cast<unsigned>(threads_.size()) + 1;
    }

    /// Calls `task(i)` for every i in [0, count), each once, in any order and on any thread, and
    /// returns when all are done. Results must go to disjoint slots. May be called from several
    /// threads, not from a task. What a task throws (out of memory) ends the loop early and is
    /// thrown here.
    void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task);

private:
    struct Loop;
    void work();
    static void run(Loop& loop);

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Loop*> loops_;
    bool stopping_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace facet::base
