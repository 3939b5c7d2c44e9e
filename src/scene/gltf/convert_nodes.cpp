// Nodes: which scene is shown, and the meshes placed by its nodes.
// SPDX-License-Identifier: MIT
#include "scene/animate.h"
#include "scene/gltf/elements.h"
#include "scene/gltf/instancing.h"
#include "scene/gltf/mesh.h"
#include "scene/gltf/placed.h"
#include "scene/gltf/points_and_lines.h"
#include "scene/gltf/transforms.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>
#include <span>
#include <utility>

namespace facet::scene::gltf {
namespace {

using base::ErrorCode;

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

/// Errors: input_invalid (a matrix that is not finite).
base::Result<std::vector<Skin>> read_skins(const Import& import) {
    std::vector<Skin> skins;
    for (std::size_t s = 0; s < count_at(import.asset.json, "skins"); ++s) {
        const Json& json = *element_at(import.asset.json, "skins", s);
        Skin& skin = skins.emplace_back();
        for (const Json& joint : *find(json, "joints"))
            skin.joints.push_back(joint.get<std::uint32_t>());
        skin.joint_from_object.assign(skin.joints.size(), Mat4(1.0F));
        const auto bind_index = index_at(json, "inverseBindMatrices");
        if (!bind_index || !import.asset.accessors[*bind_index].is_sound) continue;
        const Accessor& accessor = import.asset.accessors[*bind_index];
        if (accessor.components != 16) continue;
        const std::vector<float> floats = read_floats(accessor);
        const std::size_t used = std::min<std::size_t>(floats.size(), skin.joints.size() * 16);
        if (auto finite = check_finite(std::span(floats).first(used),
                                       pointer_text("skins", s, "/inverseBindMatrices"));
            !finite)
            return tl::unexpected(finite.error());
        for (std::size_t j = 0; j < skin.joints.size() && j < accessor.count; ++j)
            for (std::size_t i = 0; i < 16; ++i)
                skin.joint_from_object[j][static_cast<int>(i / 4)][static_cast<int>(i % 4)] =
                    floats[j * 16 + i];
    }
    return skins;
}

/// What placing meshes takes.
struct Placer {
    Import& import;
    Rig& rig;
    const Pose& pose;  ///< nothing moved
    /// Meshes made so far that nothing deforms, by mesh and whether turned round.
    std::map<std::pair<std::size_t, bool>, std::vector<MeshId>> meshes;
    /// Of the rig, by mesh: each with its primitive.
    std::map<std::size_t, std::vector<std::pair<PrimitiveId, std::size_t>>> shapes;
    Joints joints;
};

MeshId add_mesh(Import& import, Mesh mesh) {
    import.scene.meshes.push_back(std::move(mesh));
    return {static_cast<std::uint32_t>(import.scene.meshes.size() - 1)};
}

/// Meshes of the mesh's primitives, for this pose alone.
base::Status build_meshes(Import& import, std::size_t mesh, const Deformation& by,
                          Placing& placing) {
    for (std::size_t p = 0; p < import.model.meshes[mesh].primitives.size(); ++p) {
        auto shape = read_shape(import, {mesh, p}, by.weights);
        if (!shape) return base::fail(shape.error());
        if (!*shape) continue;
        auto built = build_mesh(import, {mesh, p}, std::move(**shape), by);
        if (!built) return base::fail(built.error());
        if (!built->indices.empty()) placing.meshes.push_back(add_mesh(import, std::move(*built)));
    }
    return {};
}

/// The same, with what it takes to build them for another pose.
base::Status build_shapes(Placer& placer, std::size_t mesh, const Deformation& by,
                          Placing& placing) {
    Import& import = placer.import;
    const auto [known, is_new] = placer.shapes.try_emplace(mesh);
    for (std::size_t p = 0; is_new && p < import.model.meshes[mesh].primitives.size(); ++p) {
        auto shape = read_shape(import, {mesh, p}, by.weights);
        if (!shape) return base::fail(shape.error());
        if (!*shape) continue;
        known->second.emplace_back(PrimitiveId{mesh, p}, placer.rig.shapes.size());
        placer.rig.shapes.push_back(std::move(**shape));
    }
    for (const auto& [id, index] : known->second) {
        const Shape& shape = placer.rig.shapes[index];
        if (auto taken = import.take_memory(shape.mesh.positions_m.size() * vertex_bytes +
                                                shape.mesh.indices.size() * sizeof(std::uint32_t),
                                            pointer_text("meshes", mesh));
            !taken)
            return taken;
        auto built = build_mesh(import, id, shape, by);
        if (!built) return base::fail(built.error());
        placing.meshes.push_back(add_mesh(import, std::move(*built)));
        placing.shapes.push_back(index);
    }
    return {};
}

bool has_targets(const tinygltf::Mesh& mesh) {
    return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                       [](const tinygltf::Primitive& p) { return !p.targets.empty(); });
}

/// Makes the placing's meshes, and instances of them where there is something to see.
base::Status place_mesh(Placer& placer, Placing placing, std::span<const Mat4> joints) {
    Import& import = placer.import;
    const tinygltf::Node& node = import.model.nodes[placing.node];
    const auto mesh = static_cast<std::size_t>(node.mesh);
    const Mat4 world = placing.skin
                           ? placing.node_from_copy
                           : placer.pose.world_from_node[placing.node] * placing.node_from_copy;
    const bool is_seen = !is_flat(world);
    if (!is_seen)
        import.warn(pointer_text("nodes", placing.node), "mesh scaled to nothing is not drawn");
    if (!is_seen && !import.has_clips) return {};
    const Deformation by{placing.weights, joints,
                         is_mirroring(joints.empty() ? world : joints.front())};
    const bool deforms = placing.skin || has_targets(import.model.meshes[mesh]);
    const bool is_own = placing.skin || !node.weights.empty();
    if (import.has_clips && deforms) {
        if (auto built = build_shapes(placer, mesh, by, placing); !built) return built;
    } else if (is_own && deforms) {
        if (auto built = build_meshes(import, mesh, by, placing); !built) return built;
    } else {
        const std::pair key(mesh, by.is_mirrored);
        if (const auto found = placer.meshes.find(key); found != placer.meshes.end())
            placing.meshes = found->second;
        else if (auto built = build_meshes(import, mesh, by, placing); !built)
            return built;
        placer.meshes[key] = placing.meshes;
    }
    const std::size_t instances = std::max<std::size_t>(placing.meshes.size(), 1);
    const std::size_t bytes = instances * (sizeof(Instance) + placing.name.size()) +
                              (import.has_clips ? sizeof(Placing) + placing.name.size() +
                                                      placing.weights.size() * sizeof(float)
                                                : 0);
    if (auto taken = import.take_memory(bytes, pointer_text("nodes", placing.node)); !taken)
        return taken;
    for (const MeshId id : placing.meshes)
        if (is_seen && !import.scene.meshes[id.index].indices.empty())
            import.scene.instances.push_back({.mesh = id,
                                              .world_from_object = world,
                                              .node = placing.name,
                                              .object_id = placing.node + 1});
    if (import.has_clips) placer.rig.placings.push_back(std::move(placing));
    return {};
}

base::Status convert_mesh_node(Placer& placer, std::uint32_t index) {
    const Import& import = placer.import;
    const tinygltf::Node& node = import.model.nodes[index];
    const std::vector<double>& weights =
        node.weights.empty() ? import.model.meshes[static_cast<std::size_t>(node.mesh)].weights
                             : node.weights;
    Placing placing{.node = index, .name = node.name};
    for (const double weight : weights) placing.weights.push_back(static_cast<float>(weight));
    std::span<const Mat4> joints;
    if (node.skin >= 0) {
        // A skinned mesh stands where its joints are; its own node's place is ignored (glTF 2.0,
        // section 3.7.3.3).
        placing.skin = static_cast<std::uint32_t>(node.skin);
        joints = placer.joints.of(*placing.skin);
    }
    const auto copies = read_instances(import, index);
    if (!copies) return base::fail(copies.error());
    if (copies->empty()) return place_mesh(placer, std::move(placing), joints);
    for (const Mat4& node_from_copy : *copies) {
        Placing copy = placing;
        copy.node_from_copy = node_from_copy;
        if (auto placed = place_mesh(placer, std::move(copy), joints); !placed) return placed;
    }
    return {};
}

}  // namespace

base::Status convert_nodes(Import& import, Rig& rig) {
    const auto roots = choose_roots(import);
    if (!roots) return base::fail(roots.error());
    const auto shown = read_rig_nodes(import, *roots, rig);
    if (!shown) return base::fail(shown.error());
    auto skins = read_skins(import);
    if (!skins) return base::fail(skins.error());
    rig.skins = std::move(*skins);
    const Pose pose = pose_at(rig, nullptr, 0.0);
    measure_lines(import, *shown, pose.world_from_node);
    Placer placer{import, rig, pose, {}, {}, Joints(rig, pose)};
    for (const std::uint32_t index : *shown) {
        const tinygltf::Node& node = import.model.nodes[index];
        if (node.mesh >= 0)
            if (auto placed = convert_mesh_node(placer, index); !placed) return placed;
        if (node.camera >= 0) place_camera(import, index, pose.world_from_node[index]);
        place_light(import, index, pose.world_from_node[index]);
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
