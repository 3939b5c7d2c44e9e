// Loading a scene: from a file, from bytes, or one of the built-in ones.
// SPDX-License-Identifier: MIT
#include "scene/load.h"

#include "base/file.h"
#include "base/resources.h"
#include "base/text.h"
#include "scene/gltf/gltf.h"

#include <algorithm>
#include <system_error>

namespace facet::scene {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;

/// The file of a built-in scene in `folder`; an empty path where there is none.
fs::path find_builtin(const fs::path& folder, const std::string& name) {
    std::error_code error;
    for (const fs::path& file : {folder / (name + ".glb"), folder / (name + ".gltf"),
                                 folder / name / (name + ".gltf"), folder / name / (name + ".glb")})
        if (fs::is_regular_file(file, error)) return file;
    return {};
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// A scene's own file, read.
struct MainFile {
    fs::path path;
    base::Bytes bytes;
};
base::Result<MainFile> read_main(const std::string& name, const base::Limits& limits) {
    auto path = path_of(name);
    if (!path) return tl::unexpected(path.error());
    auto bytes = base::read_file(*path, limits.file_bytes);
    if (!bytes) return base::fail(base::in_file(bytes.error(), name));
    return MainFile{std::move(*path), std::move(*bytes)};
}

gltf::Origin origin_of(const std::string& label, std::optional<fs::path> folder,
                       const LoadOptions& options) {
    return {
        .label = label, .folder = std::move(folder), .allowed_folders = options.allowed_folders};
}

}  // namespace

base::Result<fs::path> path_of(const std::string& name) {
    if (!name.starts_with(builtin_prefix)) return fs::path(name);
    const std::string scene = name.substr(builtin_prefix.size());
    const std::vector<std::string> names = builtin_scene_names();
    const auto folder = base::data_folder();
    if (!folder) return tl::unexpected(folder.error());
    if (std::find(names.begin(), names.end(), scene) != names.end())
        return find_builtin(*folder / "resources/scenes", scene);
    return base::fail({.code = ErrorCode::usage,
                       .file = name,
                       .what = "no such built-in scene",
                       .found = {},
                       .remedy = base::suggestion(scene, names)});
}

std::string stem_of(const std::string& name) {
    if (name == "-") return "stdin";
    if (name.starts_with(builtin_prefix)) return name.substr(builtin_prefix.size());
    return fs::path(name).stem().string();
}

std::vector<std::string> builtin_scene_names() {
    std::vector<std::string> names;
    const auto data = base::data_folder();
    if (!data) return names;
    const fs::path folder = *data / "resources/scenes";
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string stem = entry->path().stem().string();
        if (!find_builtin(folder, stem).empty()) names.push_back(stem);
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

base::Result<Loaded> load(const std::string& name, const LoadOptions& options,
                          const base::Limits& limits, base::ThreadPool& pool) {
    auto file = read_main(name, limits);
    if (!file) return tl::unexpected(file.error());
    auto loaded =
        gltf::import_bytes(std::move(file->bytes), origin_of(name, folder_of(file->path), options),
                           options, limits, pool);
    if (!loaded) return loaded;
    loaded->reads.insert(loaded->reads.begin(), file->path);
    if (loaded->scene.name.empty()) loaded->scene.name = file->path.stem().string();
    return loaded;
}

base::Result<Loaded> load_bytes(std::span<const std::byte> bytes, const std::string& label,
                                const LoadOptions& options, const base::Limits& limits,
                                base::ThreadPool& pool) {
    return gltf::import_bytes(base::Bytes(bytes.begin(), bytes.end()),
                              origin_of(label, options.base_folder, options), options, limits,
                              pool);
}

base::Result<std::string> content_hash(const std::string& name, const LoadOptions& options,
                                       const base::Limits& limits) {
    auto file = read_main(name, limits);
    if (!file) return tl::unexpected(file.error());
    return gltf::content_hash(std::move(file->bytes),
                              origin_of(name, folder_of(file->path), options), limits);
}

base::Result<std::vector<Finding>> check(const std::string& name, const LoadOptions& options,
                                         const base::Limits& limits) {
    auto file = read_main(name, limits);
    if (!file) return tl::unexpected(file.error());
    return gltf::check_bytes(std::move(file->bytes),
                             origin_of(name, folder_of(file->path), options), limits);
}

}  // namespace facet::scene
