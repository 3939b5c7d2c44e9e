// Loading a scene: from a file, from bytes, or one of the built-in ones.
// SPDX-License-Identifier: MIT
#include "scene/load.h"

#include "base/file.h"
#include "scene/builtin_files.h"
#include "scene/gltf/gltf.h"

namespace facet::scene {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// A scene's own file, read.
struct MainFile {
    fs::path path;
    base::Bytes bytes;
};
base::Result<MainFile> read_main(const std::string& name, const base::Limits& limits) {
    auto path = file_of(name, builtin_scenes);
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

std::string stem_of(const std::string& name) {
    if (name == "-") return "stdin";
    if (name.starts_with(builtin_prefix)) return name.substr(builtin_prefix.size());
    return fs::path(name).stem().string();
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
