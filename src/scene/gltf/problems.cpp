// Problems of a glTF file, and what they become for the user.
// SPDX-License-Identifier: MIT
#include "scene/gltf/problems.h"

namespace facet::scene::gltf {

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
