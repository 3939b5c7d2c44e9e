// The pool: every index once, on any number of threads.
// SPDX-License-Identifier: MIT
#include "base/thread_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>

namespace facet::base {
namespace {

TEST(ThreadPool, CallsEveryIndexOnceForAnyNumberOfThreads) {
    for (const unsigned threads : {1U, 2U, 5U}) {
        ThreadPool pool(threads);
        EXPECT_EQ(pool.thread_count(), threads);
        for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
            std::vector<std::atomic<int>> calls(count);
            pool.parallel_for(count, [&](std::size_t i) { ++calls[i]; });
            for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(calls[i], 1) << i << " of " << count;
        }
    }
}
TEST(ThreadPool, ServesSeveralCallersAtOnce) {
    ThreadPool pool(3);
    std::vector<long> sums(4);
    std::vector<std::thread> callers;
    for (std::size_t c = 0; c < sums.size(); ++c)
        callers.emplace_back([&, c] {
            for (int round = 0; round < 50; ++round) {
                std::vector<long> slots(100);
                pool.parallel_for(slots.size(),
                                  [&](std::size_t i) { slots[i] = static_cast<long>(i); });
                sums[c] += std::accumulate(slots.begin(), slots.end(), 0L);
            }
        });
    for (std::thread& caller : callers) caller.join();
    for (const long sum : sums) EXPECT_EQ(sum, 50L * 4950L);
}
TEST(ThreadPool, HandsOnWhatATaskThrows) {
    for (const unsigned threads : {1U, 3U}) {
        ThreadPool pool(threads);
        EXPECT_THROW(pool.parallel_for(100,
                                       [](std::size_t i) {
                                           if (i == 7) throw std::runtime_error("seven");
                                       }),
                     std::runtime_error);
        std::atomic<int> calls{0};
        pool.parallel_for(10, [&](std::size_t) { ++calls; });  // and goes on working
        EXPECT_EQ(calls, 10);
    }
}

}  // namespace
}  // namespace facet::base
