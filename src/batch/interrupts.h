// Signals that ask to end, heard by a loop instead of ending it anywhere.
// SPDX-License-Identifier: MIT
#pragma once

#include <signal.h>

namespace facet::batch {

/// While this lives, SIGINT, SIGTERM and SIGHUP are only remembered, and only let through within
/// ppoll(..., mask()); a second one ends the process at once. One at a time.
class Interrupts {
public:
    Interrupts();
    ~Interrupts();
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

    /// The signal that came; 0: none.
    [[nodiscard]] int signal() const;
    [[nodiscard]] const sigset_t& mask() const { return before_; }

private:
    sigset_t before_{};
    struct sigaction old_[3]{};
};

}  // namespace facet::batch
