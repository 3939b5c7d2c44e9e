// How far a long command has come, on standard error.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "cli/io.h"

#include <chrono>
#include <string>

namespace facet::cli {

/// A bar with rate and time left on a terminal, redrawn in place; elsewhere a plain line every five
/// seconds at most. Nothing where the command is quiet, and nothing for what is done within a
/// second.
class ProgressLine {
public:
    explicit ProgressLine(Io& io);
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void update(double done, std::string_view what);
    /// Removes the bar, so that a line can be written; the next update draws it again.
    void clear();
    [[nodiscard]] base::Progress sink() {
        return [this](double done, std::string_view what) { update(done, what); };
    }

private:
    Io* io_;
    bool on_terminal_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point last_;
};

/// `[#####-----]  50 %  what  12 s left`. `elapsed_s` gives the rate.
[[nodiscard]] std::string progress_text(double done, std::string_view what, double elapsed_s,
                                        bool bar);

}  // namespace facet::cli
