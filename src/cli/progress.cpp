// How far a long command has come.
// SPDX-License-Identifier: MIT
#include "cli/progress.h"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace facet::cli {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr double quiet_s = 1.0;
constexpr double bar_every_s = 0.1;
constexpr double line_every_s = 5.0;
constexpr int bar_width = 24;

std::string time_left(double seconds) {
    const auto whole = static_cast<long long>(seconds + 0.5);
    if (whole < 60) return fmt::format("{} s left", whole);
    const long long minutes = whole / 60;
    if (minutes < 60) return fmt::format("{} min {:02} s left", minutes, whole % 60);
    return fmt::format("{} h {:02} min left", minutes / 60, minutes % 60);
}

}  // namespace

std::string progress_text(double done, std::string_view what, double elapsed_s, bool bar) {
    const double share = std::clamp(done, 0.0, 1.0);
    std::string text;
    if (bar) {
        const int full = static_cast<int>(share * bar_width);
        text = "[" + std::string(static_cast<std::size_t>(full), '#') +
               std::string(static_cast<std::size_t>(bar_width - full), '-') + "] ";
    }
    text += fmt::format("{:3.0f} %  {}", share * 100.0, what);
    if (share > 0.0 && elapsed_s > 0.0) text += "  " + time_left(elapsed_s / share * (1.0 - share));
    return text;
}

ProgressLine::ProgressLine(Io& io)
    : io_(&io),
      on_terminal_(::isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {}

void ProgressLine::clear() {
    if (drawn_) std::fputs("\r\033[K", stderr);
    drawn_ = false;
}

void ProgressLine::update(double done, std::string_view what) {
    if (io_->quiet) return;
    const auto now = std::chrono::steady_clock::now();
    const double elapsed = Seconds(now - start_).count();
    const double since = Seconds(now - last_).count();
    if (elapsed < quiet_s || since < (on_terminal_ ? bar_every_s : line_every_s)) return;
    last_ = now;
    if (!on_terminal_) return io_->note("facet: " + progress_text(done, what, elapsed, false));
    drawn_ = true;
    std::fputs(("\r\033[K" + progress_text(done, what, elapsed, true)).c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace facet::cli
