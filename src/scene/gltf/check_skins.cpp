// Checks of skins: their matrices, and joints that hang together.
// SPDX-License-Identifier: MIT
#include "scene/gltf/attributes.h"
#include "scene/gltf/check.h"
#include "scene/gltf/hierarchy.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::scene::gltf {
namespace {

void check_matrices(const Asset& asset, const Json& skin, const std::string& where,
                    Problems& problems) {
    const auto index = index_at(skin, "inverseBindMatrices");
    if (!index || *index >= asset.accessors.size() || asset.accessors[*index].components == 0)
        return;
    const Accessor& accessor = asset.accessors[*index];
    const std::string at = where + "/inverseBindMatrices";
    if (format_of(accessor) != "MAT4 f32")
        problems.error("SKIN_IBM_INVALID_FORMAT", at, "wrong format for bind matrices",
                       format_of(accessor));
    if (const std::size_t joints = count_at(skin, "joints"); accessor.count < joints)
        problems.error("INVALID_IBM_ACCESSOR_COUNT", at, "fewer bind matrices than joints",
                       fmt::format("{}, but there are {}", accessor.count, joints));
    const auto view = index_at(*element_at(asset.json, "accessors", *index), "bufferView");
    const Json* const view_json = view ? element_at(asset.json, "bufferViews", *view) : nullptr;
    if (view_json != nullptr && find(*view_json, "byteStride") != nullptr)
        problems.error("SKIN_IBM_ACCESSOR_WITH_BYTESTRIDE", at,
                       "bind matrices in a buffer view with a stride");
}

std::vector<std::uint32_t> joints_of(const Json& skin, std::size_t node_count) {
    std::vector<std::uint32_t> joints;
    for (std::size_t j = 0; j < count_at(skin, "joints"); ++j)
        if (const auto joint = as_unsigned(*element_at(skin, "joints", j));
            joint && *joint < node_count)
            joints.push_back(static_cast<std::uint32_t>(*joint));
    return joints;
}

void check_joints(const Json& skin, const Placement& placement, const std::string& where,
                  Problems& problems) {
    const std::vector<std::uint32_t> joints = joints_of(skin, placement.roots.size());
    if (count_at(skin, "joints") == 0) return;
    const bool are_all = joints.size() == count_at(skin, "joints");
    const bool have_root = std::all_of(joints.begin(), joints.end(), [&](std::uint32_t joint) {
        return placement.roots[joint] == placement.roots[joints[0]];
    });
    if (!are_all || !have_root) {
        problems.error("SKIN_NO_COMMON_ROOT", where + "/joints", "joints have no common root");
        return;
    }
    const auto skeleton = index_at(skin, "skeleton");
    if (!skeleton || *skeleton >= placement.roots.size()) return;
    const bool is_above = std::all_of(joints.begin(), joints.end(), [&](std::uint32_t joint) {
        return placement.enter[*skeleton] <= placement.enter[joint] &&
               placement.enter[joint] < placement.leave[*skeleton];
    });
    if (!is_above)
        problems.error("SKIN_SKELETON_INVALID", where + "/skeleton",
                       "skeleton is no common root of the joints", std::to_string(*skeleton));
}

/// By node: the scenes that list it, rising.
std::vector<std::vector<std::uint32_t>> scenes_of_nodes(const Json& json, std::size_t node_count) {
    std::vector<std::vector<std::uint32_t>> out(node_count);
    for (std::uint32_t s = 0; s < count_at(json, "scenes"); ++s) {
        const Json& scene = *element_at(json, "scenes", s);
        for (std::size_t n = 0; n < count_at(scene, "nodes"); ++n)
            if (const auto node = as_unsigned(*element_at(scene, "nodes", n));
                node && *node < node_count)
                out[*node].push_back(s);
    }
    return out;
}

/// A skinned mesh in a scene that its joints are not in.
void check_scenes(const Json& json, const Placement& placement, Problems& problems) {
    const std::size_t node_count = placement.roots.size();
    const auto scenes = scenes_of_nodes(json, node_count);
    for (std::uint32_t n = 0; n < node_count; ++n) {
        const Json& node = *element_at(json, "nodes", n);
        const auto skin_index = index_at(node, "skin");
        const Json* const skin = skin_index ? element_at(json, "skins", *skin_index) : nullptr;
        const Json* const joint = skin != nullptr ? element_at(*skin, "joints", 0) : nullptr;
        const std::uint64_t first =
            joint != nullptr ? as_unsigned(*joint).value_or(node_count) : node_count;
        if (find(node, "mesh") == nullptr || first >= node_count) continue;
        const auto& with_mesh = scenes[placement.roots[n]];
        const auto& with_joints = scenes[placement.roots[first]];
        // Both rise, so the first difference is found in the length of the shorter.
        const auto [missing, other] = std::mismatch(with_mesh.begin(), with_mesh.end(),
                                                    with_joints.begin(), with_joints.end());
        if (missing != with_mesh.end() && (other == with_joints.end() || *other > *missing))
            problems.error("NODE_SKIN_NO_SCENE", pointer_text("nodes", n),
                           "skinned mesh is in a scene without its joints",
                           fmt::format("scene {}", *missing));
    }
}

bool has_transform(const Json& node) {
    return find(node, "matrix") != nullptr || find(node, "translation") != nullptr ||
           find(node, "rotation") != nullptr || find(node, "scale") != nullptr;
}

/// Transforms that a skin overrules.
void note_ignored_transforms(const Json& json, const Hierarchy& hierarchy,
                             const Placement& placement, Problems& problems) {
    std::vector<bool> is_moved(placement.roots.size(), false);  // by itself or from above
    for (const std::uint32_t n : placement.order) {
        const Json& node = *element_at(json, "nodes", n);
        const std::uint32_t parent = hierarchy.parents[n];
        const bool is_moved_from_above = parent != Hierarchy::none && is_moved[parent];
        is_moved[n] = is_moved_from_above || has_transform(node);
        if (find(node, "skin") == nullptr || find(node, "mesh") == nullptr) continue;
        const std::string where = pointer_text("nodes", n);
        if (has_transform(node))
            problems.note(Severity::warning, "NODE_SKINNED_MESH_LOCAL_TRANSFORMS", where,
                          "a skinned mesh is not moved by its own node");
        if (is_moved_from_above)
            problems.note(Severity::warning, "NODE_SKINNED_MESH_PARENT_TRANSFORMS", where,
                          "a skinned mesh is not moved by the nodes above it");
        else if (parent != Hierarchy::none)
            problems.note(Severity::information, "NODE_SKINNED_MESH_NON_ROOT", where,
                          "a node with a skinned mesh should be a root");
    }
}

}  // namespace

void check_skins(const Asset& asset, Problems& problems) {
    if (count_at(asset.json, "skins") == 0) return;
    const Hierarchy hierarchy = read_hierarchy(asset.json, nullptr);
    if (!hierarchy.looped.empty()) return;  // above and below mean nothing then
    const Placement placement = place(hierarchy);
    for (std::size_t i = 0; i < count_at(asset.json, "skins"); ++i) {
        const Json& skin = *element_at(asset.json, "skins", i);
        const std::string where = pointer_text("skins", i);
        check_matrices(asset, skin, where, problems);
        check_joints(skin, placement, where, problems);
    }
    check_scenes(asset.json, placement, problems);
    note_ignored_transforms(asset.json, hierarchy, placement, problems);
}

}  // namespace facet::scene::gltf
