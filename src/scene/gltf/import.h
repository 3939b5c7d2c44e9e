// What the steps that turn a checked glTF model into a scene share.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"
#include "base/thread_pool.h"
#include "scene/gltf/asset.h"
#include "scene/gltf/model.h"
#include "scene/load.h"
#include "scene/rig.h"
#include "scene/scene.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace facet::scene::gltf {

/// One import. References outlive it; only `scene`, `warnings` and `asset` (reads, memory) are
/// written.
struct Import {
    Asset& asset;
    const tinygltf::Model& model;
    const LoadOptions& options;
    const base::Limits& limits;
    base::ThreadPool& pool;
    Scene& scene;
    base::Warnings& warnings;

    std::vector<std::uint32_t> image_sources;      ///< by ImageId: index in the file
    std::map<std::string, ImageId> images_by_key;  ///< uri, or "#" and the index
    std::optional<std::size_t> variant;            ///< of KHR_materials_variants
    bool has_clips = false;                        ///< meshes have to be kept for other poses
    std::optional<MaterialId> default_material;
    std::vector<std::map<std::string, MaterialId>>
        reduced_materials;  ///< by material: without some textures
    std::map<std::uint32_t, MaterialId> unlit_materials = {};  ///< by material
    /// By mesh of the file: the scene's diagonal in units of the mesh; empty where nothing needs
    /// it.
    std::vector<float> line_scales = {};

    /// Sets `bytes` aside for what is about to be made. Errors: limit_reached when they are not
    /// there.
    [[nodiscard]] base::Status take_memory(std::size_t bytes, const std::string& where) {
        if (bytes > asset.memory_left)
            return base::fail({.code = base::ErrorCode::limit_reached,
                               .where = where,
                               .what = "the scene needs more memory than allowed",
                               .found = std::to_string(bytes) + " bytes more, " +
                                        std::to_string(asset.memory_left) + " left",
                               .remedy = "raise --max-memory"});
        asset.memory_left -= bytes;
        return {};
    }
    /// One more warning, up to a number that nobody reads.
    void warn(std::string where, std::string what, std::string found = {},
              std::string remedy = {}) {
        constexpr std::size_t most = 1000;
        if (warnings.size() >= most) return;
        warnings.push_back({.file = {},
                            .where = std::move(where),
                            .what = std::move(what),
                            .found = std::move(found),
                            .remedy = std::move(remedy)});
    }
};

/// The id of image `index` of the file; two that name one file are one. Decoding comes later.
[[nodiscard]] ImageId use_image(Import& import, std::uint32_t index);
/// Reads, measures and decodes every image in use, on the pool. A missing or damaged one leaves
/// null pixels and a warning; an error under --strict. Errors: limit_reached before anything is
/// allocated.
[[nodiscard]] base::Status load_images(Import& import);

/// All of the file's materials, same order.
void convert_materials(Import& import);
/// White stands in for a picture that is missing, which no normal map may be: its normals would
/// lean over.
void drop_missing_normal_maps(Scene& scene);
/// The material for a primitive without one (glTF 2.0, section 3.9.7).
[[nodiscard]] MaterialId default_material(Import& import);
/// The same material, less the textures whose coordinates the mesh lacks; one warning each.
[[nodiscard]] MaterialId material_for(Import& import, MaterialId material, const Mesh& mesh,
                                      const std::string& where);

/// Everything that hangs on nodes: meshes as placed, cameras, lights. Fills all of the rig but its
/// clips.
[[nodiscard]] base::Status convert_nodes(Import& import, Rig& rig);
/// The file's animations. What is wrong with one is its fault, and a warning. `problems`: what the
/// checks found.
[[nodiscard]] std::vector<Clip> read_clips(Import& import, const Problems& problems);

}  // namespace facet::scene::gltf
