// Checks of the document as a whole: its version and its lists of extensions.
// SPDX-License-Identifier: MIT
#include "scene/gltf/check.h"
#include "scene/gltf/extensions.h"
#include "scene/gltf/schema.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace facet::scene::gltf {
namespace {

using Version = std::pair<unsigned, unsigned>;

/// "2.0"; nothing else before, between or after.
std::optional<Version> parse_version(std::string_view text) {
    Version version;
    const char* const end = text.data() + text.size();
    const auto major = std::from_chars(text.data(), end, version.first);
    if (major.ec != std::errc{} || major.ptr == end || *major.ptr != '.') return std::nullopt;
    const auto minor = std::from_chars(major.ptr + 1, end, version.second);
    if (minor.ec != std::errc{} || minor.ptr != end) return std::nullopt;
    return version;
}

std::optional<Version> version_at(const Json& asset, std::string_view key, Problems& problems) {
    const Json* const value = find(asset, key);
    if (value == nullptr || !value->is_string()) return std::nullopt;
    const auto version = parse_version(value->get<std::string>());
    if (!version)
        problems.error("PATTERN_MISMATCH", "/asset/" + std::string(key),
                       "not a version of the form 2.0", brief(*value));
    return version;
}

/// Vendor prefix in capitals, then an underscore: "KHR_x".
bool has_extension_form(std::string_view name) {
    const std::size_t line = name.find('_');
    if (line == std::string_view::npos || line == 0 || line + 1 == name.size()) return false;
    return std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(line),
                       [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); });
}

using Names = std::set<std::string, std::less<>>;

Names names_at(const Json& json, std::string_view key) {
    Names names;
    for (std::size_t i = 0; i < count_at(json, key); ++i)
        if (const Json& name = *element_at(json, key, i); name.is_string())
            names.insert(name.get<std::string>());
    return names;
}

bool is_known_to_schema(std::string_view name) {
    return std::any_of(extension_rules().begin(), extension_rules().end(),
                       [&](const ExtensionRule& rule) { return rule.name == name; });
}

void check_used(const Json& json, Problems& problems) {
    const Names required = names_at(json, "extensionsRequired");
    for (std::size_t i = 0; i < count_at(json, "extensionsUsed"); ++i) {
        const Json& name = *element_at(json, "extensionsUsed", i);
        if (!name.is_string()) continue;
        const std::string where = pointer_text("extensionsUsed", i);
        if (!has_extension_form(name.get<std::string>()))
            problems.note(Severity::warning, "INVALID_EXTENSION_NAME_FORMAT", where,
                          "extension's name has no vendor prefix", brief(name));
        else if (!is_known_to_schema(name.get<std::string>()) &&
                 !is_implemented(name.get<std::string>()))
            problems.note(Severity::information, "UNSUPPORTED_EXTENSION", where,
                          "contents of this extension are not checked", brief(name));
        // Quantised attributes have no plain form to fall back to.
        if (name == "KHR_mesh_quantization" && !required.contains(name.get<std::string>()))
            problems.error("NON_REQUIRED_EXTENSION", where,
                           "extension must be in extensionsRequired too", brief(name));
    }
}

}  // namespace

void check_version(const Json& json, Problems& problems) {
    const Json* const asset = find(json, "asset");
    if (asset == nullptr) return;
    const auto version = version_at(*asset, "version", problems);
    const auto needed = version_at(*asset, "minVersion", problems);
    if (version && version->first != 2)
        problems.add({.code = "UNKNOWN_ASSET_MAJOR_VERSION",
                      .pointer = "/asset/version",
                      .what = "glTF version is not 2",
                      .found = string_at(*asset, "version"),
                      .remedy = version->first < 2 ? "convert it to glTF 2.0" : "",
                      .error = base::ErrorCode::feature_missing});
    else if (version && version->second > 0)
        problems.note(Severity::warning, "UNKNOWN_ASSET_MINOR_VERSION", "/asset/version",
                      "glTF version is newer than 2.0", string_at(*asset, "version"));
    if (version && needed && *needed > *version)
        problems.error("ASSET_MIN_VERSION_GREATER_THAN_VERSION", "/asset/minVersion",
                       "minVersion is above version", string_at(*asset, "minVersion"));
    else if (needed && *needed > Version(2, 0))
        problems.add({.severity = Severity::information,
                      .code = "UNKNOWN_ASSET_MIN_VERSION",
                      .pointer = "/asset/minVersion",
                      .what = "file asks for a newer glTF than 2.0",
                      .found = string_at(*asset, "minVersion"),
                      .error = base::ErrorCode::input_invalid});
}

void check_extension_lists(const Json& json, Problems& problems) {
    check_used(json, problems);
    const Names used = names_at(json, "extensionsUsed");
    for (std::size_t i = 0; i < count_at(json, "extensionsRequired"); ++i) {
        const Json& name = *element_at(json, "extensionsRequired", i);
        if (name.is_string() && !used.contains(name.get<std::string>()))
            problems.error("UNUSED_EXTENSION_REQUIRED", pointer_text("extensionsRequired", i),
                           "required extension is not in extensionsUsed", brief(name));
    }
}

}  // namespace facet::scene::gltf
