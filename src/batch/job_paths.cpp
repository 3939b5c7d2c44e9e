// Paths in a job file: relative to it, and nowhere else unless allowed.
// SPDX-License-Identifier: MIT
#include "batch/job_paths.h"

#include "base/file.h"
#include "batch/glob.h"
#include "scene/environment.h"
#include "scene/light_spec.h"
#include "scene/scene.h"
#include "tables/material.h"

#include <algorithm>

namespace facet::batch {
namespace {

namespace fs = std::filesystem;

bool is_texture_path(std::string_view path) {
    const std::string_view key = path.substr(path.rfind('.') + 1);
    return path.starts_with("material") &&
           std::ranges::any_of(tables::material_textures,
                               [&](const auto& row) { return row.key == key; });
}

bool is_builtin(std::string_view name) { return name.starts_with(scene::builtin_prefix); }
bool is_light_file_path(std::string_view path) {
    return path.starts_with("light") && path.ends_with(".file");
}

}  // namespace

base::Result<std::string> JobPaths::in_job(const std::string& text) const {
    if (text.find("://") != std::string::npos)
        return base::invalid("network is never used", text, "download it");
    if (text.empty() || text.find('\0') != std::string::npos)
        return base::invalid("not a file name", text);
    const fs::path path = (folder_ / text).lexically_normal();
    std::error_code error;
    const fs::path folder = folder_.empty() ? "." : folder_;
    const fs::path resolved = fs::weakly_canonical(fs::absolute(path), error);
    if (error) return base::invalid("cannot be resolved: " + error.message(), text);
    const auto holds = [&](const fs::path& allowed) {
        return base::is_beneath(resolved, fs::weakly_canonical(allowed, error));
    };
    if (!holds(folder) && std::ranges::none_of(allowed_, holds))
        return base::invalid("outside the job's folder", text,
                             "--allow-read DIR if it may be read");
    return path.string();
}

base::Status JobPaths::resolve_scenes(const Given& given, std::vector<Json>& scenes,
                                      base::Warnings& warnings) const {
    std::vector<Json> out;
    for (const Json& value : scenes) {
        if (!value.is_string()) return base::invalid("a scene is a text", value.dump());
        const auto& text = value.get_ref<const std::string&>();
        if (text == "-") return base::invalid("a job reads no standard input", text, "give a file");
        if (is_builtin(text)) {
            out.emplace_back(text);
            continue;
        }
        const bool has_pattern = is_pattern(text) && !fs::exists(folder_ / text);
        std::vector<std::string> files{text};
        if (has_pattern) files = matching_files(folder_, text);
        if (files.empty())
            warnings.push_back(
                {.where = given.pointer, .what = "no file is named so", .found = text});
        for (const std::string& file : files) {
            const auto path = in_job(file);
            if (!path) return tl::unexpected(path.error());
            std::error_code error;
            if (!has_pattern && !fs::exists(*path, error))
                warnings.push_back({.where = given.pointer, .what = "no such file", .found = text});
            out.emplace_back(*path);
        }
    }
    scenes = std::move(out);
    return {};
}

base::Status JobPaths::resolve(const Given& given, Json& value) const {
    const auto resolve_text = [&](Json& text) -> base::Status {
        const auto path = in_job(text.get<std::string>());
        if (!path) return tl::unexpected(path.error());
        text = *path;
        return {};
    };
    if (given.kind == AxisKind::path) {
        const bool is_file = (is_texture_path(given.key) || is_light_file_path(given.key)) &&
                             value.is_string() && value != "none" &&
                             !is_builtin(value.get_ref<const std::string&>());
        return is_file ? resolve_text(value) : base::Status{};
    }
    if (given.key == "env" && value.is_string()) {
        const auto file = scene::environment_file(value.get<std::string>());
        if (!file) return tl::unexpected(file.error());
        return *file ? resolve_text(value) : base::Status{};
    }
    if (given.key == "light") {
        for (Json& one : value.is_array() ? value : value = Json::array({value})) {
            if (!one.is_string()) continue;
            const auto light = scene::with_light_file(
                one.get<std::string>(),
                [&](const std::string& file) { return is_builtin(file) ? file : in_job(file); });
            if (!light) return tl::unexpected(light.error());
            one = *light;
        }
        return {};
    }
    if (given.key != "material") return {};
    for (Json& one : value.is_array() ? value : value = Json::array({value})) {
        if (!one.is_string()) continue;
        const auto text = one.get<std::string>();
        const std::size_t equals = text.rfind('=');
        if (equals == std::string::npos || !text.ends_with(".json")) continue;
        const auto path = in_job(text.substr(equals + 1));
        if (!path) return tl::unexpected(path.error());
        one = text.substr(0, equals + 1) + *path;
    }
    return {};
}

}  // namespace facet::batch
