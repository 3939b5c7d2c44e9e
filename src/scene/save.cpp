// Saving a scene.
// SPDX-License-Identifier: MIT
#include "scene/save.h"

#include "base/file.h"
#include "scene/builtin_files.h"
#include "scene/gltf/save_materials.h"

#include <algorithm>
#include <cctype>

namespace facet::scene {
namespace {

namespace fs = std::filesystem;

std::string ending_of(const fs::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

/// Whether what the scene came from is in the file still: it may have been written since.
bool has_sources(const gltf::Asset& asset, const Scene& scene) {
    const std::size_t materials = gltf::count_at(asset.json, "materials");
    const std::size_t nodes = gltf::count_at(asset.json, "nodes");
    return std::all_of(scene.materials.begin(), scene.materials.end(),
                       [&](const Material& m) { return !m.source || *m.source < materials; }) &&
           std::all_of(scene.lights.begin(), scene.lights.end(), [&](const Light& light) {
               if (!light.source_node) return true;
               const gltf::Json* const node =
                   *light.source_node < nodes
                       ? gltf::element_at(asset.json, "nodes", *light.source_node)
                       : nullptr;
               const gltf::Json* const use =
                   node == nullptr ? nullptr
                                   : gltf::find_path(*node, "extensions/KHR_lights_punctual");
               return use != nullptr && gltf::index_at(*use, "light").has_value();
           });
}

tl::unexpected<base::Error> changed_since(const std::string& source) {
    return base::fail({.code = base::ErrorCode::input_invalid,
                       .file = source,
                       .what = "is not the file that was opened any more",
                       .remedy = "save under another name, or open it again"});
}

base::Result<gltf::Asset> open(const SaveRequest& request, const fs::path& path,
                               const base::Limits& limits) {
    auto file = base::read_file(path, limits.file_bytes);
    if (!file) return tl::unexpected(base::in_file(file.error(), request.source));
    gltf::Problems problems;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    auto asset = gltf::open_asset(std::move(*file),
                                  {.label = path.string(),
                                   .folder = folder,
                                   .allowed_folders = request.options.allowed_folders},
                                  limits, problems);
    if (!asset || !has_sources(*asset, request.original)) return changed_since(request.source);
    gltf::read_buffers(*asset, limits, problems);
    return std::move(*asset);
}

/// The same file, whatever it is called.
bool is_same_folder(const fs::path& a, const fs::path& b) {
    std::error_code error;
    const auto folder = [](const fs::path& path) {
        return path.has_parent_path() ? path.parent_path() : fs::path(".");
    };
    return fs::equivalent(folder(a), folder(b), error) && !error;
}

base::Status write(const fs::path& folder, const std::vector<gltf::SideFile>& files, Saved& out) {
    for (const gltf::SideFile& file : files) {
        const fs::path path = folder / file.path;
        std::error_code error;
        fs::create_directories(path.parent_path(), error);
        if (auto s = base::write_file_atomically(path, file.bytes); !s) return s;
        out.files.push_back(path);
    }
    return {};
}

base::Result<Saved> save_unguarded(const SaveRequest& request, const base::Limits& limits) {
    const std::string ending = ending_of(request.target);
    const bool to_glb = ending == ".glb";
    if (!to_glb && ending != ".gltf")
        return base::fail({.code = base::ErrorCode::usage,
                           .file = request.target.string(),
                           .what = "a scene is saved as .gltf or .glb",
                           .found = ending});
    if (auto writable = base::check_writable(request.target); !writable)
        return tl::unexpected(writable.error());
    const auto path = file_of(request.source, builtin_scenes);
    if (!path) return tl::unexpected(path.error());
    auto asset = open(request, *path, limits);
    if (!asset) return tl::unexpected(asset.error());
    auto document = gltf::document_of(*asset);
    if (!document) return tl::unexpected(base::in_file(document.error(), request.source));
    Saved out;
    const std::string stem = request.target.stem().string();
    if (to_glb && !asset->is_glb)
        if (auto s = gltf::pack(*asset, *document); !s) return tl::unexpected(s.error());
    if (auto s = gltf::save_materials(*document, request.original, request.edited, {to_glb, stem},
                                      limits, out.warnings);
        !s)
        return tl::unexpected(s.error());
    gltf::save_lights(*document, request.original, request.edited, out.warnings);
    if (!to_glb && asset->is_glb) gltf::unpack(*document, stem + ".bin");
    const fs::path folder = request.target.parent_path();
    if (!to_glb && !is_same_folder(*path, request.target)) {
        auto files = gltf::named_files(*asset, *document);
        if (!files) return tl::unexpected(files.error());
        if (auto s = write(folder, *files, out); !s) return tl::unexpected(s.error());
    }
    auto bytes = to_glb ? gltf::glb_bytes(*document)
                        : base::Result<base::Bytes>(gltf::gltf_bytes(*document));
    if (!bytes) return tl::unexpected(base::in_file(bytes.error(), request.target.string()));
    if (auto s = write(folder, document->new_files, out); !s) return tl::unexpected(s.error());
    if (auto s = base::write_file_atomically(request.target, *bytes); !s)
        return tl::unexpected(s.error());
    out.files.push_back(request.target);
    return out;
}

}  // namespace

base::Result<Saved> save(const SaveRequest& request, const base::Limits& limits) {
    try {
        return save_unguarded(request, limits);
    } catch (const nlohmann::json::exception&) {
        // A member of another type than glTF says, where loading did not have to look.
        return base::fail({.code = base::ErrorCode::input_invalid,
                           .file = request.source,
                           .what = "cannot be saved over: a part of it is not as glTF has it",
                           .remedy = "facet check tells which"});
    }
}

}  // namespace facet::scene
