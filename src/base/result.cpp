// Errors as values: exit codes and the line a user reads.
// SPDX-License-Identifier: MIT
#include "base/result.h"

#include "base/text.h"

namespace facet::base {
namespace {

std::string line(std::string_view file, std::string_view where, std::string_view what,
                 std::string_view found, std::string_view remedy) {
    std::string out;
    if (!file.empty()) out += escaped(file) + ":";
    if (!where.empty()) out += escaped(where) + ":";
    if (!out.empty()) out += " ";
    out += escaped(what, 400);
    if (!found.empty()) out += " (" + escaped(found) + ")";
    if (!remedy.empty()) out += "; " + escaped(remedy, 400);
    return out;
}

}  // namespace

int exit_code(ErrorCode code) noexcept {
    switch (code) {
        case ErrorCode::usage:
            return 2;
        case ErrorCode::input_invalid:
            return 3;
        case ErrorCode::feature_missing:
            return 4;
        case ErrorCode::limit_reached:
            return 5;
        case ErrorCode::no_backend:
            return 6;
        case ErrorCode::internal:
            return 70;
        case ErrorCode::temporary:
            return 75;
    }
    return 70;
}

std::string to_line(const Error& e) { return line(e.file, e.where, e.what, e.found, e.remedy); }
std::string to_line(const Warning& w) { return line(w.file, w.where, w.what, w.found, w.remedy); }

}  // namespace facet::base
