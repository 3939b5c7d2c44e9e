// Work spread over the cores.
// SPDX-License-Identifier: MIT
#include "base/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>

namespace facet::base {

struct ThreadPool::Loop {
    const std::function<void(std::size_t)>& task;
    std::size_t count;
    std::atomic<std::size_t> next{0};
    unsigned helpers = 0;  ///< workers inside; guarded by mutex_
    std::condition_variable done;
    std::atomic_flag failed;
    std::exception_ptr failure;  ///< written by whoever set `failed`; read when no worker is inside
};

ThreadPool::ThreadPool(unsigned thread_count) {
    if (thread_count == 0) thread_count = std::max(1U, std::thread::hardware_concurrency());
    try {
        for (unsigned i = 1; i < thread_count; ++i) threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
        // A limit on threads: the work gets done by those that there are.
    }
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::run(Loop& loop) {
    try {
        for (std::size_t i = loop.next++; i < loop.count; i = loop.next++) loop.task(i);
    } catch (...) {
        if (!loop.failed.test_and_set()) loop.failure = std::current_exception();
        loop.next = loop.count;
    }
}

void ThreadPool::parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) {
    Loop loop{.task = task, .count = count, .done = {}, .failed = {}, .failure = {}};
    const bool shared = count > 1 && !threads_.empty();
    if (shared) {
        {
            const std::lock_guard lock(mutex_);
            loops_.push_back(&loop);
        }
        wake_.notify_all();
    }
    run(loop);
    if (shared) {
        std::unique_lock lock(mutex_);
        std::erase(loops_, &loop);
        loop.done.wait(lock, [&] { return loop.helpers == 0; });
    }
    if (loop.failure) std::rethrow_exception(loop.failure);
}

void ThreadPool::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock, [this] { return stopping_ || !loops_.empty(); });
        if (stopping_) return;
        Loop& loop = *loops_.front();
        ++loop.helpers;
        lock.unlock();
        run(loop);
        lock.lock();
        --loop.helpers;
        if (!loops_.empty() && loops_.front() == &loop) loops_.pop_front();
        if (loop.helpers == 0) loop.done.notify_all();
    }
}

}  // namespace facet::base
