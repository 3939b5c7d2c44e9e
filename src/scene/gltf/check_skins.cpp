// Checks of skins: their matrices, and joints that hang together.
// SPDX-License-Identifier: MIT
#include "scene/gltf/attributes.h"
#include "scene/gltf/check.h"
#include "scene/gltf/hierarchy.h"

#include <spdlog/fmt/fmt.h>

#include <set>

namespace facet::scene::gltf {
namespace {

/// Bounded, as a chain of parents may be as long as the file likes.
constexpr std::size_t max_climb = 10'000;

/// `node` and its ancestors, nearest first.
std::vector<std::uint32_t> ancestors(const Hierarchy& hierarchy, std::uint32_t node) {
    std::vector<std::uint32_t> out;
    for (std::uint32_t at = node; at != Hierarchy::none && out.size() < max_climb;
         at = hierarchy.parents[at])
        out.push_back(at);
    return out;
}

/// Nodes that all joints have for an ancestor (or are); empty where there is no common root.
std::set<std::uint32_t> common_ancestors(const Hierarchy& hierarchy,
                                         const std::vector<std::uint32_t>& joints) {
    std::set<std::uint32_t> common;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const std::vector<std::uint32_t> own = ancestors(hierarchy, joints[i]);
        if (i == 0) {
            common.insert(own.begin(), own.end());
            continue;
        }
        const std::set<std::uint32_t> own_set(own.begin(), own.end());
        std::erase_if(common, [&](std::uint32_t node) { return !own_set.contains(node); });
    }
    return common;
}

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

void check_joints(const Json& skin, const Hierarchy& hierarchy, const std::string& where,
                  Problems& problems) {
    const std::vector<std::uint32_t> joints = joints_of(skin, hierarchy.parents.size());
    if (count_at(skin, "joints") == 0) return;
    const std::set<std::uint32_t> common = common_ancestors(hierarchy, joints);
    if (common.empty() || joints.size() != count_at(skin, "joints")) {
        problems.error("SKIN_NO_COMMON_ROOT", where + "/joints", "joints have no common root");
        return;
    }
    const auto skeleton = index_at(skin, "skeleton");
    if (skeleton && *skeleton < hierarchy.parents.size() && !common.contains(*skeleton))
        problems.error("SKIN_SKELETON_INVALID", where + "/skeleton",
                       "skeleton is no common root of the joints", std::to_string(*skeleton));
}

std::uint32_t root_of(const Hierarchy& hierarchy, std::uint32_t node) {
    return ancestors(hierarchy, node).back();
}

/// Whether scene `index` shows `root`.
bool shows(const Json& json, std::size_t index, std::uint32_t root) {
    const Json* const nodes = find(*element_at(json, "scenes", index), "nodes");
    if (nodes == nullptr || !nodes->is_array()) return false;
    for (const Json& node : *nodes)
        if (as_unsigned(node) == root) return true;
    return false;
}

/// A skinned mesh in a scene that its joints are not in.
void check_scenes(const Json& json, const Hierarchy& hierarchy, Problems& problems) {
    for (std::uint32_t n = 0; n < hierarchy.parents.size(); ++n) {
        const Json& node = *element_at(json, "nodes", n);
        const auto skin_index = index_at(node, "skin");
        const Json* const skin = skin_index ? element_at(json, "skins", *skin_index) : nullptr;
        if (skin == nullptr || find(node, "mesh") == nullptr) continue;
        const std::vector<std::uint32_t> joints = joints_of(*skin, hierarchy.parents.size());
        if (joints.empty()) continue;
        for (std::size_t s = 0; s < count_at(json, "scenes"); ++s)
            if (shows(json, s, root_of(hierarchy, n)) &&
                !shows(json, s, root_of(hierarchy, joints[0])))
                problems.error("NODE_SKIN_NO_SCENE", pointer_text("nodes", n),
                               "skinned mesh is in a scene without its joints",
                               fmt::format("scene {}", s));
    }
}

bool has_transform(const Json& node) {
    return find(node, "matrix") != nullptr || find(node, "translation") != nullptr ||
           find(node, "rotation") != nullptr || find(node, "scale") != nullptr;
}

/// Transforms that a skin overrules.
void note_ignored_transforms(const Json& json, const Hierarchy& hierarchy, Problems& problems) {
    for (std::uint32_t n = 0; n < hierarchy.parents.size(); ++n) {
        const Json& node = *element_at(json, "nodes", n);
        if (find(node, "skin") == nullptr || find(node, "mesh") == nullptr) continue;
        const std::string where = pointer_text("nodes", n);
        if (has_transform(node))
            problems.note(Severity::warning, "NODE_SKINNED_MESH_LOCAL_TRANSFORMS", where,
                          "a skinned mesh is not moved by its own node");
        if (hierarchy.parents[n] == Hierarchy::none) continue;
        bool is_moved = false;
        for (const std::uint32_t above : ancestors(hierarchy, hierarchy.parents[n]))
            is_moved = is_moved || has_transform(*element_at(json, "nodes", above));
        if (is_moved)
            problems.note(Severity::warning, "NODE_SKINNED_MESH_PARENT_TRANSFORMS", where,
                          "a skinned mesh is not moved by the nodes above it");
        else
            problems.note(Severity::information, "NODE_SKINNED_MESH_NON_ROOT", where,
                          "a node with a skinned mesh should be a root");
    }
}

}  // namespace

void check_skins(const Asset& asset, Problems& problems) {
    if (count_at(asset.json, "skins") == 0) return;
    const Hierarchy hierarchy = read_hierarchy(asset.json, nullptr);
    if (!hierarchy.looped.empty()) return;  // ancestors mean nothing then
    for (std::size_t i = 0; i < count_at(asset.json, "skins"); ++i) {
        const Json& skin = *element_at(asset.json, "skins", i);
        const std::string where = pointer_text("skins", i);
        check_matrices(asset, skin, where, problems);
        check_joints(skin, hierarchy, where, problems);
    }
    check_scenes(asset.json, hierarchy, problems);
    note_ignored_transforms(asset.json, hierarchy, problems);
}

}  // namespace facet::scene::gltf
