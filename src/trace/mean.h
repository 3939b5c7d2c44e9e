// The mean of some draws, and how certain it is.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace facet::trace {

struct Mean {
    double sum = 0.0;
    double squares = 0.0;
    void add(float x) {
        sum += static_cast<double>(x);
        squares += static_cast<double>(x) * static_cast<double>(x);
    }
    /// Of the mean of n.
    [[nodiscard]] float variance(std::uint32_t n) const {
        const double mean = sum / n;
        // A single draw says nothing of its error: as much as itself.
        if (n < 2) return static_cast<float>(mean * mean);
        return static_cast<float>(std::max(squares / n - mean * mean, 0.0) / (n - 1));
    }
};

}  // namespace facet::trace
