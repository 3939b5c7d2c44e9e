// The log: what the program says while it works, to standard error. Passed by reference, never
// global. SPDX-License-Identifier: MIT
#pragma once

#include <spdlog/fmt/fmt.h>

#include <memory>
#include <string_view>

namespace facet::base {

enum class LogLevel { debug, info, warn, error, off };

/// Speaks to standard error. `error`: a failed item; `warn`: a picture that may differ from what
/// was asked; `info`: one line per stage; `debug`: sizes and times. Safe to use from several
/// threads.
class Log {
public:
    /// Lines below `level` are dropped. `color` asks for ANSI colours.
    explicit Log(LogLevel level = LogLevel::warn, bool color = false);
    ~Log();
    Log(Log&&) noexcept;
    Log& operator=(Log&&) noexcept;

    [[nodiscard]] bool shows(LogLevel level) const noexcept { return level >= level_; }
    /// Writes `message` as one line behind `facet: `, or `facet: warning: ` for a warning.
    void write(LogLevel level, std::string_view message);

    template <class... Args>
    void debug(fmt::format_string<Args...> text, Args&&... args) {
        if (shows(LogLevel::debug))
            write(LogLevel::debug, fmt::format(text, std::forward<Args>(args)...));
    }
    template <class... Args>
    void info(fmt::format_string<Args...> text, Args&&... args) {
        if (shows(LogLevel::info))
            write(LogLevel::info, fmt::format(text, std::forward<Args>(args)...));
    }
    template <class... Args>
    void warn(fmt::format_string<Args...> text, Args&&... args) {
        if (shows(LogLevel::warn))
            write(LogLevel::warn, fmt::format(text, std::forward<Args>(args)...));
    }

private:
    struct Sink;
    std::unique_ptr<Sink> sink_;
    LogLevel level_;
};

}  // namespace facet::base
