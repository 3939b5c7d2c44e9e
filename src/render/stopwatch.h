// Wall-clock time, in laps.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace facet::render {

class Stopwatch {
public:
    /// Milliseconds since the start or the last lap.
    [[nodiscard]] double lap_ms() {
        const auto now = std::chrono::steady_clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
        return ms;
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace facet::render
