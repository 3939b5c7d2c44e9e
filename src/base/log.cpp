// The log, on spdlog; the only file that names it (its bundled fmt is the project's fmt).
// SPDX-License-Identifier: MIT
#include "base/log.h"

#include <spdlog/logger.h>
#include <spdlog/sinks/ansicolor_sink.h>

namespace facet::base {

struct Log::Sink {
    spdlog::logger logger;
};

Log::Log(LogLevel level, bool color) : level_(level) {
    const auto mode = color ? spdlog::color_mode::always : spdlog::color_mode::never;
    auto sink = std::make_shared<spdlog::sinks::ansicolor_stderr_sink_mt>(mode);
    sink->set_pattern("%v");
    sink_ = std::make_unique<Sink>(Sink{spdlog::logger("facet", std::move(sink))});
    sink_->logger.set_level(spdlog::level::trace);
    sink_->logger.flush_on(spdlog::level::trace);
}
Log::~Log() = default;
Log::Log(Log&&) noexcept = default;
Log& Log::operator=(Log&&) noexcept = default;

void Log::write(LogLevel level, std::string_view message) {
    if (!shows(level)) return;
    switch (level) {
        case LogLevel::debug:
            sink_->logger.debug("facet: {}", message);
            break;
        case LogLevel::info:
            sink_->logger.info("facet: {}", message);
            break;
        case LogLevel::warn:
            sink_->logger.warn("facet: warning: {}", message);
            break;
        case LogLevel::error:
            sink_->logger.error("facet: {}", message);
            break;
        case LogLevel::off:
            break;
    }
}

}  // namespace facet::base
