// The nodes of a glTF model, from the roots down without recursion.
// SPDX-License-Identifier: MIT
#include "scene/gltf/transforms.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

namespace facet::scene::gltf {
namespace {

using base::ErrorCode;

Vec3 to_vec3(const std::vector<double>& v, const Vec3& otherwise) {
    if (v.size() != 3) return otherwise;
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

math::Quat rotation_of(Import& import, const tinygltf::Node& node, std::size_t index) {
    const std::vector<double>& r = node.rotation;  // x y z w
    if (r.size() != 4) return {1.0F, 0.0F, 0.0F, 0.0F};
    const double size = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
    if (std::fabs(size - 1.0) > 0.005)
        import.warn(pointer_text("nodes", index, "/rotation"),
                    "quaternion is not of length 1, scaled", fmt::format("{}", size));
    if (!(size > 1e-12)) return {1.0F, 0.0F, 0.0F, 0.0F};
    math::Quat q;
    q.w = static_cast<float>(r[3] / size);
    q.x = static_cast<float>(r[0] / size);
    q.y = static_cast<float>(r[1] / size);
    q.z = static_cast<float>(r[2] / size);
    return q;
}

RigNode rig_node(Import& import, std::size_t index) {
    const tinygltf::Node& node = import.model.nodes[index];
    RigNode out;
    if (node.matrix.size() == 16) {
        Mat4 matrix;
        for (std::size_t i = 0; i < 16; ++i)  // by columns, as GLM's
            matrix[static_cast<int>(i / 4)][static_cast<int>(i % 4)] =
                static_cast<float>(node.matrix[i]);
        out.matrix = matrix;
        return out;
    }
    out.translation = to_vec3(node.translation, out.translation);
    out.rotation = rotation_of(import, node, index);
    out.scale = to_vec3(node.scale, out.scale);
    return out;
}

bool is_visible(const Json& json, std::size_t index) {
    const Json* const node = element_at(json, "nodes", index);
    const Json* const visibility =
        node ? find_path(*node, "extensions/KHR_node_visibility") : nullptr;
    return visibility == nullptr || bool_at(*visibility, "visible").value_or(true);
}

struct Visit {
    std::uint32_t node = 0;
    std::size_t depth = 0;
    bool is_shown = false;
};

/// One walk down from `roots`; nodes seen before are left alone unless the walk would repeat for
/// ever.
base::Status walk(Import& import, const std::vector<int>& roots, std::vector<bool>& seen, Rig& rig,
                  std::vector<std::uint32_t>* shown) {
    std::vector<Visit> stack;
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
        stack.push_back(
            {.node = static_cast<std::uint32_t>(*root), .depth = 1, .is_shown = shown != nullptr});
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        if (visit.node >= seen.size() || seen[visit.node]) continue;
        seen[visit.node] = true;
        if (visit.depth > import.limits.node_depth)
            return base::fail({.code = ErrorCode::limit_reached,
                               .where = pointer_text("nodes", visit.node),
                               .what = "nodes are nested too deep",
                               .found = fmt::format("more than {}", import.limits.node_depth)});
        rig.order.push_back(visit.node);
        const bool is_node_shown = visit.is_shown && is_visible(import.asset.json, visit.node);
        if (is_node_shown) shown->push_back(visit.node);
        const std::vector<int>& children = import.model.nodes[visit.node].children;
        for (auto child = children.rbegin(); child != children.rend(); ++child) {
            const auto index = static_cast<std::uint32_t>(*child);
            if (index >= seen.size() || seen[index]) continue;
            rig.nodes[index].parent = visit.node;
            stack.push_back({.node = index, .depth = visit.depth + 1, .is_shown = is_node_shown});
        }
    }
    return {};
}

}  // namespace

base::Result<std::vector<std::uint32_t>> read_rig_nodes(Import& import,
                                                        const std::vector<int>& roots, Rig& rig) {
    const std::size_t count = import.model.nodes.size();
    std::vector<bool> is_child(count, false);
    for (const tinygltf::Node& node : import.model.nodes)
        for (const int child : node.children)
            if (child >= 0 && static_cast<std::size_t>(child) < count)
                is_child[static_cast<std::size_t>(child)] = true;
    std::vector<int> others;  // joints may lie in no scene at all
    for (std::size_t i = 0; i < count; ++i) {
        rig.nodes.push_back(rig_node(import, i));
        if (!is_child[i]) others.push_back(static_cast<int>(i));
    }
    std::vector<bool> seen(count, false);
    std::vector<std::uint32_t> shown;
    if (auto walked = walk(import, roots, seen, rig, &shown); !walked)
        return tl::unexpected(walked.error());
    if (auto walked = walk(import, others, seen, rig, nullptr); !walked)
        return tl::unexpected(walked.error());
    return shown;
}

}  // namespace facet::scene::gltf
