// Problems of a glTF file: what `check` prints and `load` decides by.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "scene/load.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace facet::scene::gltf {

using Severity = Finding::Severity;

/// One problem, in the validator's code and in the parts of our own error line.
struct Problem {
    Severity severity = Severity::error;
    std::string code;     ///< of the Khronos glTF-Validator where it has one
    std::string pointer;  ///< JSON pointer, or @offset in a GLB
    std::string what;
    std::string found;
    std::string remedy = {};
    base::ErrorCode error = base::ErrorCode::input_invalid;  ///< how `load` fails on it
};

/// Collects problems; drops those beyond `max_count`, so that a broken file of a million values
/// stays small. The worst of those takes the last one's place: a file is judged by it.
class Problems {
public:
    void add(Problem problem);
    void error(std::string_view code, std::string pointer, std::string what,
               std::string found = {}) {
        add({.code = std::string(code),
             .pointer = std::move(pointer),
             .what = std::move(what),
             .found = std::move(found)});
    }
    void note(Severity severity, std::string_view code, std::string pointer, std::string what,
              std::string found = {}) {
        add({.severity = severity,
             .code = std::string(code),
             .pointer = std::move(pointer),
             .what = std::move(what),
             .found = std::move(found)});
    }
    [[nodiscard]] const std::vector<Problem>& all() const noexcept { return all_; }
    [[nodiscard]] std::size_t error_count() const noexcept { return error_count_; }

private:
    static constexpr std::size_t max_count = 10'000;
    std::vector<Problem> all_;
    std::size_t error_count_ = 0;
};

[[nodiscard]] base::Error to_error(const Problem& problem);
[[nodiscard]] base::Warning to_warning(const Problem& problem);
[[nodiscard]] Finding to_finding(const Problem& problem);
/// A problem of code `code` out of an error from below (a file that cannot be read).
[[nodiscard]] Problem to_problem(std::string_view code, std::string pointer,
                                 const base::Error& error);

}  // namespace facet::scene::gltf
