// Worker processes: started, fed and heard.
// SPDX-License-Identifier: MIT
#include "batch/crew.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace facet::batch {
namespace {

void close_end(int& file) {
    if (file >= 0) ::close(file);
    file = -1;
}

/// In the child: signals are the parent's to understand, and it dies with that.
void settle(pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) std::_Exit(1);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) ::signal(number, SIG_IGN);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

}  // namespace

Crew::~Crew() {
    for (Hand& hand : hands_)
        if (hand.is_running()) stop(hand);
}

base::Status Crew::start(Hand& hand) {
    const auto failed = [](const char* what) {
        const bool is_limit = errno == EMFILE;
        return base::fail(
            {.code = is_limit ? base::ErrorCode::limit_reached : base::ErrorCode::temporary,
             .what = what,
             .found = std::strerror(errno),
             .remedy = is_limit ? "ulimit -n 256 allows more open files"
                                : "fewer --jobs, or close other programs"});
    };
    std::array<int, 2> orders{};
    std::array<int, 2> results{};
    if (::pipe2(orders.data(), O_CLOEXEC) != 0) return failed("no pipe to a worker");
    if (::pipe2(results.data(), O_CLOEXEC) != 0) {
        for (const int file : orders) ::close(file);
        return failed("no pipe from a worker");
    }
    const pid_t parent = ::getpid();
    const pid_t pid = ::fork();
    if (pid == 0) {
        settle(parent);
        // The others' ends too: a worker that held one would keep its sibling waiting for orders.
        for (Hand& other : hands_) {
            close_end(other.orders);
            close_end(other.results);
        }
        ::close(orders[1]);
        ::close(results[0]);
        work(in_, orders[0], results[1]);
        std::_Exit(0);
    }
    ::close(orders[0]);
    ::close(results[1]);
    if (pid < 0) {
        ::close(orders[1]);
        ::close(results[0]);
        return failed("no process for a worker");
    }
    ::fcntl(results[0], F_SETFL, O_NONBLOCK);
    hand = {.pid = pid, .orders = orders[1], .results = results[0], .queue = hand.queue};
    return {};
}

base::Status Crew::give(Hand& hand, std::size_t item) {
    if (!hand.is_running())
        if (auto started = start(hand); !started) return started;
    if (hand.in_flight.empty()) hand.oldest_since = Clock::now();
    hand.in_flight.push_back(item);
    // A worker that died meanwhile is found out by its other pipe.
    const std::string line = std::to_string(item) + "\n";
    static_cast<void>(!::write(hand.orders, line.data(), line.size()));
    return {};
}

std::vector<std::string> Crew::hear(Hand& hand) {
    std::array<char, 65536> bytes{};
    ssize_t count = 0;
    while ((count = ::read(hand.results, bytes.data(), bytes.size())) > 0)
        hand.text.append(bytes.data(), static_cast<std::size_t>(count));
    std::vector<std::string> lines;
    for (std::size_t end = 0; (end = hand.text.find('\n')) != std::string::npos;) {
        lines.push_back(hand.text.substr(0, end));
        hand.text.erase(0, end + 1);
    }
    return lines;
}

int Crew::stop(Hand& hand) {
    int status = 0;
    ::kill(hand.pid, SIGKILL);
    while (::waitpid(hand.pid, &status, 0) < 0 && errno == EINTR) {
    }
    close_end(hand.orders);
    close_end(hand.results);
    hand.pid = -1;
    hand.text.clear();
    hand.is_alone = false;
    return status;
}

void Crew::dismiss(Hand& hand) { close_end(hand.orders); }

}  // namespace facet::batch
