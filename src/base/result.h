// Errors as values: what went wrong, where, and what the user can do about it.
// SPDX-License-Identifier: MIT
#pragma once

#include <tl/expected.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace facet::base {

/// The kinds of failure; exit_code() maps each to the program's exit status (contract, "Rules").
enum class ErrorCode {
    usage,            ///< 2: the command line or an option's value is wrong
    input_invalid,    ///< 3: an input is unreadable or invalid
    feature_missing,  ///< 4: an input needs a feature that is not there
    limit_reached,    ///< 5: a size, memory or time limit was reached
    no_backend,       ///< 6: no usable GL backend
    internal,         ///< 70: a fault of the program's own
    temporary,        ///< 75: try again later (lock held, disk full)
};

/// The parts of the one line that a user reads: `facet: FILE:WHERE: what (found); remedy`.
/// Empty parts are left out. Text that comes from a file is escaped when the line is made.
struct Error {
    ErrorCode code = ErrorCode::internal;
    std::string file;    ///< the file or option the error is about
    std::string where;   ///< JSON pointer, byte offset, header field or line in it
    std::string what;    ///< the problem, in lower case, without a full stop
    std::string found;   ///< the value found
    std::string remedy;  ///< what to do about it
};

/// Something wrong but usable: the picture may differ from what was asked for.
struct Warning {
    std::string file;
    std::string where;
    std::string what;
    std::string found;
    std::string remedy;
    bool spares_result = false;  ///< what was asked for is there all the same: no error to --strict
};
using Warnings = std::vector<Warning>;

template <class T>
using Result = tl::expected<T, Error>;
using Status = Result<void>;

/// An Error ready to be returned from any function that returns a Result.
[[nodiscard]] inline tl::unexpected<Error> fail(Error error) {
    return tl::unexpected<Error>(std::move(error));
}

/// The same for a file's words that cannot be used: input_invalid.
[[nodiscard]] inline tl::unexpected<Error> invalid(std::string what, std::string found = {},
                                                   std::string remedy = {}) {
    return fail({.code = ErrorCode::input_invalid,
                 .what = std::move(what),
                 .found = std::move(found),
                 .remedy = std::move(remedy)});
}

/// Adds the file name to an error that does not name one yet.
[[nodiscard]] inline Error in_file(Error error, std::string_view file) {
    if (error.file.empty()) error.file = file;
    return error;
}

[[nodiscard]] int exit_code(ErrorCode code) noexcept;
/// `FILE:WHERE: what (found); remedy`, escaped, one line, without the `facet:` in front.
[[nodiscard]] std::string to_line(const Error& error);
[[nodiscard]] std::string to_line(const Warning& warning);

}  // namespace facet::base
