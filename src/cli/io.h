// What a command speaks through: results to standard output, everything else to standard error.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "base/result.h"
#include "tables/exit_codes.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdio>
#include <functional>
#include <span>
#include <string_view>

namespace facet::cli {

using tables::Exit;

/// The two streams and how to speak on them. Text from files is escaped by whoever makes the line.
class Io {
public:
    /// The streams stay the caller's and must outlive this.
    Io(std::FILE* out, std::FILE* err);

    bool json = false;                            ///< results as one JSON object a line
    bool quiet = false;                           ///< no warnings, no log
    base::LogLevel level = base::LogLevel::warn;  ///< of log()
    bool color = false;

    /// One line of result.
    void print(std::string_view line);
    /// One object of result, as one line whatever stands in its strings.
    void print_object(const nlohmann::ordered_json& object);
    /// Bytes of result (a picture on standard output).
    void print_bytes(std::span<const std::byte> bytes);
    /// `facet: FILE:WHERE: what (found); remedy` on standard error; with --json an object too.
    void complain(const base::Error& error);
    /// Likewise with `facet: warning:`; at most 20, then how many more. `as_objects` off: the
    /// command's own object holds them.
    void warn(std::span<const base::Warning> warnings, bool as_objects = true);
    /// A line on standard error as it stands.
    void note(std::string_view line);
    [[nodiscard]] base::Log log() const {
        return base::Log(quiet ? base::LogLevel::off : level, color);
    }
    /// Flushes. Whether every result arrived: false when the reader went away or the disk is full.
    [[nodiscard]] bool finish();
    [[nodiscard]] bool out_is_terminal() const;

private:
    std::FILE* out_;
    std::FILE* err_;
    bool whole_ = true;
};

/// What a command does once its flags are read.
using Job = std::function<base::Result<Exit>(Io&)>;

}  // namespace facet::cli
