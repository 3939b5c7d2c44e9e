// Worker processes: started, fed and heard, and gone when this is.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/worker.h"

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <vector>

struct pollfd;

namespace facet::batch {

using Clock = std::chrono::steady_clock;

/// One worker as its parent sees it.
struct Hand {
    pid_t pid = -1;  ///< below 0: not started
    int orders = -1;
    int results = -1;
    std::string text;                   ///< the beginning of a line
    std::deque<std::size_t> in_flight;  ///< given and not heard of, oldest first
    Clock::time_point oldest_since;     ///< when the oldest of them became that
    std::size_t queue = 0;              ///< of the scheduler's queues; 0: none
    bool is_alone = false;              ///< its one item is to have nothing beside it

    [[nodiscard]] bool is_running() const { return pid > 0; }
};

class Crew {
public:
    /// Processes are forked from this one: it has no threads, and no GL.
    Crew(const WorkerInputs& in, std::size_t count) : in_(in), hands_(count) {}
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    [[nodiscard]] std::span<Hand> hands() { return hands_; }
    /// Starts the process where there is none, and gives it an item. Errors: temporary (no
    /// process), limit_reached (of open files).
    [[nodiscard]] base::Status give(Hand& hand, std::size_t item);
    /// Reads what a worker has to say; whole lines only.
    [[nodiscard]] std::vector<std::string> hear(Hand& hand);
    /// Ends a process at once, if it has not ended; how it ended, as waitpid() tells.
    int stop(Hand& hand);
    /// Lets the idle ones go home.
    void dismiss(Hand& hand);

private:
    [[nodiscard]] base::Status start(Hand& hand);

    const WorkerInputs& in_;
    std::vector<Hand> hands_;
};

}  // namespace facet::batch
