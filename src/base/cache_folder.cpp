// Where the program may keep what it can compute again.
// SPDX-License-Identifier: MIT
#include "base/cache_folder.h"

#include <cstdlib>
#include <string_view>

namespace facet::base {
namespace {

namespace fs = std::filesystem;

std::string_view cache_variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}
bool is_switched_off() { return cache_variable("FACET_CACHE") == "off"; }

}  // namespace

fs::path cache_folder() {
    if (is_switched_off()) return {};
    const fs::path cache(cache_variable("XDG_CACHE_HOME"));
    if (cache.is_absolute()) return cache / "facet";
    const fs::path home(cache_variable("HOME"));
    return home.is_absolute() ? home / ".cache" / "facet" : fs::path();
}

Status check_cache_variable() {
    const std::string_view value = cache_variable("FACET_CACHE");
    if (value.empty() || value == "on" || value == "off") return {};
    return fail({.code = ErrorCode::usage,
                 .file = "FACET_CACHE",
                 .what = "is neither on nor off",
                 .found = std::string(value)});
}

Warnings missing_cache_folder() {
    if (is_switched_off() || !cache_folder().empty()) return {};
    return {{.file = "HOME",
             .what = "no folder for caches: shaders and environments are made anew each time",
             .remedy = "XDG_CACHE_HOME=DIR, or FACET_CACHE=off to do without"}};
}

}  // namespace facet::base
