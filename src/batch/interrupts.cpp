// Signals that ask to end, heard by a loop.
// SPDX-License-Identifier: MIT
#include "batch/interrupts.h"

#include <unistd.h>

#include <array>
#include <cstddef>

namespace facet::batch {
namespace {

constexpr std::array numbers = {SIGINT, SIGTERM, SIGHUP};

// A handler has nothing else to write to.
volatile sig_atomic_t received = 0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

void on_signal(int number) {
    if (received != 0) ::_exit(number == SIGINT ? 130 : 143);
    received = number;
}

}  // namespace

Interrupts::Interrupts() {
    received = 0;
    sigset_t blocked;
    ::sigemptyset(&blocked);
    for (const int number : numbers) ::sigaddset(&blocked, number);
    ::sigprocmask(SIG_BLOCK, &blocked, &before_);
    struct sigaction action {};
    action.sa_handler = on_signal;
    for (std::size_t i = 0; i < numbers.size(); ++i) ::sigaction(numbers[i], &action, &old_[i]);
}

Interrupts::~Interrupts() {
    for (std::size_t i = 0; i < numbers.size(); ++i) ::sigaction(numbers[i], &old_[i], nullptr);
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
}

int Interrupts::signal() const { return received; }

}  // namespace facet::batch
