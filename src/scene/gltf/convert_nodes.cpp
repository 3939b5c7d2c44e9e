// Nodes: which scene is shown, and the meshes placed by its nodes.
// SPDX-License-Identifier: MIT
#include "scene/gltf/elements.h"
#include "scene/gltf/instancing.h"
#include "scene/gltf/mesh.h"
#include "scene/gltf/placed.h"
#include "scene/gltf/transforms.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace facet::scene::gltf {
namespace {

using base::ErrorCode;

/// Meshes made so far, by mesh and whether turned round; those of a pose of their own are not kept.
struct Cache {
    std::map<std::pair<std::size_t, bool>, std::vector<MeshId>> meshes;
    std::map<std::size_t, std::vector<Mat4>> joints;  ///< by skin
};

/// Roots of the scene to show.
base::Result<std::vector<int>> choose_roots(Import& import) {
    const tinygltf::Model& model = import.model;
    if (model.scenes.empty()) {
        import.warn("/scenes", "no scene in the file, all nodes are shown");
        std::vector<bool> is_child(model.nodes.size(), false);
        for (const tinygltf::Node& node : model.nodes)
            for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
        std::vector<int> roots;
        for (std::size_t i = 0; i < model.nodes.size(); ++i)
            if (!is_child[i]) roots.push_back(static_cast<int>(i));
        return roots;
    }
    std::size_t index = 0;
    if (import.options.scene_index) {
        index = *import.options.scene_index;
        if (index >= model.scenes.size())
            return base::fail(
                {.code = ErrorCode::usage,
                 .where = "/scenes",
                 .what = "no such scene",
                 .found = fmt::format("{}, but there are {}", index, model.scenes.size())});
    } else if (model.defaultScene >= 0) {
        index = static_cast<std::size_t>(model.defaultScene);
    } else if (model.scenes.size() > 1) {
        import.warn("/scene", "no default scene, the first is shown",
                    fmt::format("{} scenes", model.scenes.size()));
    }
    import.scene.name = model.scenes[index].name;
    return model.scenes[index].nodes;
}

/// world_from_bind of every joint of a skin, from the nodes as they stand.
std::vector<Mat4> joint_matrices(const Import& import, const Transforms& transforms,
                                 std::size_t skin_index) {
    const Json& skin = *element_at(import.asset.json, "skins", skin_index);
    std::vector<Mat4> joints;
    for (const Json& joint : *find(skin, "joints"))
        joints.push_back(transforms.world_from_node[joint.get<std::size_t>()]);
    const auto bind_index = index_at(skin, "inverseBindMatrices");
    if (!bind_index || !import.asset.accessors[*bind_index].is_sound) return joints;
    const Accessor& accessor = import.asset.accessors[*bind_index];
    const std::vector<float> floats = read_floats(accessor);
    for (std::size_t j = 0; j < joints.size() && j < accessor.count && accessor.components == 16;
         ++j) {
        Mat4 bind;
        for (std::size_t i = 0; i < 16; ++i)
            bind[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = floats[j * 16 + i];
        joints[j] = joints[j] * bind;
    }
    return joints;
}

base::Result<std::vector<MeshId>> build_meshes(Import& import, std::size_t mesh_index,
                                               const Pose& pose) {
    std::vector<MeshId> ids;
    for (std::size_t p = 0; p < import.model.meshes[mesh_index].primitives.size(); ++p) {
        auto mesh = build_mesh(import, mesh_index, p, pose);
        if (!mesh) return tl::unexpected(mesh.error());
        if (!*mesh) continue;
        ids.push_back({static_cast<std::uint32_t>(import.scene.meshes.size())});
        import.scene.meshes.push_back(std::move(**mesh));
    }
    return ids;
}

/// One mesh at one place, from the cache where it has no pose of its own.
struct Placement {
    std::uint32_t node = 0;
    Mat4 world_from_object{1.0F};
};

base::Status place_mesh(Import& import, const Placement& placement, Pose pose, bool is_shared,
                        Cache& cache) {
    const tinygltf::Node& node = import.model.nodes[placement.node];
    const float determinant = glm::determinant(Mat3(placement.world_from_object));
    if (determinant == 0.0F || !std::isfinite(determinant)) {
        import.warn(pointer_text("nodes", placement.node), "mesh scaled to nothing is not drawn");
        return {};
    }
    const bool is_skinned = !pose.joints.empty();
    pose.is_mirrored = (is_skinned ? glm::determinant(Mat3(pose.joints[0])) : determinant) < 0.0F;
    const auto mesh_index = static_cast<std::size_t>(node.mesh);
    const std::pair key(mesh_index, pose.is_mirrored);
    std::vector<MeshId> ids;
    if (const auto found = cache.meshes.find(key); is_shared && found != cache.meshes.end()) {
        ids = found->second;
    } else {
        auto built = build_meshes(import, mesh_index, pose);
        if (!built) return base::fail(built.error());
        ids = std::move(*built);
        if (is_shared) cache.meshes[key] = ids;
    }
    if (auto taken = import.take_memory(std::max<std::size_t>(ids.size(), 1) * sizeof(Instance),
                                        pointer_text("nodes", placement.node));
        !taken)
        return taken;
    for (const MeshId id : ids)
        import.scene.instances.push_back({.mesh = id,
                                          .world_from_object = placement.world_from_object,
                                          .node = node.name,
                                          .object_id = placement.node + 1});
    return {};
}

base::Status convert_mesh_node(Import& import, const Transforms& transforms, std::uint32_t index,
                               Cache& cache) {
    const tinygltf::Node& node = import.model.nodes[index];
    Pose pose;
    const bool has_weights = !node.weights.empty();
    pose.morph_weights = has_weights
                             ? node.weights
                             : import.model.meshes[static_cast<std::size_t>(node.mesh)].weights;
    Placement placement{.node = index, .world_from_object = transforms.world_from_node[index]};
    const bool is_skinned = node.skin >= 0;
    if (is_skinned) {
        // A skinned mesh stands where its joints are; its own node's place is ignored (glTF 2.0,
        // section 3.7.3.3).
        const auto skin = static_cast<std::size_t>(node.skin);
        if (!cache.joints.contains(skin))
            cache.joints[skin] = joint_matrices(import, transforms, skin);
        pose.joints = cache.joints[skin];
        placement.world_from_object = Mat4(1.0F);
    }
    const bool is_shared = !has_weights && !is_skinned;
    const auto copies = read_instances(import, index);
    if (!copies) return base::fail(copies.error());
    if (copies->empty()) return place_mesh(import, placement, pose, is_shared, cache);
    for (const Mat4& node_from_copy : *copies) {
        const Placement copy{.node = index,
                             .world_from_object = placement.world_from_object * node_from_copy};
        if (auto placed = place_mesh(import, copy, pose, is_shared, cache); !placed) return placed;
    }
    return {};
}

}  // namespace

base::Status convert_nodes(Import& import) {
    const auto roots = choose_roots(import);
    if (!roots) return base::fail(roots.error());
    const auto transforms = place_nodes(import, *roots);
    if (!transforms) return base::fail(transforms.error());
    Cache cache;
    for (const std::uint32_t index : transforms->in_scene) {
        const tinygltf::Node& node = import.model.nodes[index];
        const Mat4& world_from_node = transforms->world_from_node[index];
        if (node.mesh >= 0)
            if (auto placed = convert_mesh_node(import, *transforms, index, cache); !placed)
                return placed;
        if (node.camera >= 0) place_camera(import, index, world_from_node);
        place_light(import, index, world_from_node);
    }
    if (import.scene.lights.size() > import.limits.lights)
        return base::fail({.code = ErrorCode::limit_reached,
                           .where = "/extensions/KHR_lights_punctual/lights",
                           .what = "too many lights",
                           .found = fmt::format("{}, limit {}", import.scene.lights.size(),
                                                import.limits.lights)});
    if (import.scene.instances.empty()) import.warn("/scenes", "the scene has nothing to draw");
    return {};
}

}  // namespace facet::scene::gltf
