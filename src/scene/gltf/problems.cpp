// Problems of a glTF file, and what they become for the user.
// SPDX-License-Identifier: MIT
#include "scene/gltf/problems.h"

#include "scene/gltf/severity.h"

namespace facet::scene::gltf {
namespace {

/// 0 to 2, worst last.
int rank_of(const Problem& problem) {
    if (verdict_of(problem) == Verdict::error) return 2;
    return problem.severity == Severity::error ? 1 : 0;
}

}  // namespace

void Problems::add(Problem problem) {
    if (problem.severity == Severity::error) ++error_count_;
    if (all_.size() < max_count)
        all_.push_back(std::move(problem));
    else if (rank_of(problem) > rank_of(all_.back()))
        all_.back() = std::move(problem);
}

base::Error to_error(const Problem& p) {
    return {.code = p.error,
            .file = {},
            .where = p.pointer,
            .what = p.what,
            .found = p.found,
            .remedy = p.remedy};
}

base::Warning to_warning(const Problem& p) {
    return {.file = {}, .where = p.pointer, .what = p.what, .found = p.found, .remedy = p.remedy};
}

Finding to_finding(const Problem& p) {
    return {.severity = p.severity,
            .code = p.code,
            .pointer = p.pointer,
            .message = p.found.empty() ? p.what : p.what + " (" + p.found + ")"};
}

Problem to_problem(std::string_view code, std::string pointer, const base::Error& error) {
    return {.code = std::string(code),
            .pointer = std::move(pointer),
            .what = error.what,
            .found = error.found,
            .remedy = error.remedy,
            .error = error.code};
}

}  // namespace facet::scene::gltf
