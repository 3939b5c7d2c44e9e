// Who is whose child among the nodes, read in linear time.
// SPDX-License-Identifier: MIT
#include "scene/gltf/hierarchy.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::scene::gltf {

Hierarchy read_hierarchy(const Json& json, Problems* problems) {
    const std::size_t count = count_at(json, "nodes");
    Hierarchy out{.parents = std::vector<std::uint32_t>(count, Hierarchy::none), .looped = {}};
    for (std::size_t i = 0; i < count; ++i) {
        const Json& node = *element_at(json, "nodes", i);
        for (std::size_t c = 0; c < count_at(node, "children"); ++c) {
            const auto child = as_unsigned(*element_at(node, "children", c));
            if (!child || *child >= count) continue;
            std::uint32_t& parent = out.parents[*child];
            if (parent != Hierarchy::none && parent != i && problems != nullptr)
                problems->error("NODE_PARENT_OVERRIDE", fmt::format("/nodes/{}/children/{}", i, c),
                                "node has two parents",
                                fmt::format("node {}: {} and {}", *child, parent, i));
            else if (parent == i && problems != nullptr)
                problems->error("NODE_PARENT_OVERRIDE", fmt::format("/nodes/{}/children/{}", i, c),
                                "node is the same parent's child twice",
                                fmt::format("node {}", *child));
            parent = static_cast<std::uint32_t>(i);
        }
    }
    // Every walk up ends at a root, at a loop, or where an earlier walk has been: linear in all.
    std::vector<std::uint32_t> walk_of(count, Hierarchy::none);
    for (std::uint32_t start = 0; start < count; ++start) {
        std::uint32_t at = start;
        while (at != Hierarchy::none && walk_of[at] == Hierarchy::none) {
            walk_of[at] = start;
            at = out.parents[at];
        }
        if (at == Hierarchy::none || walk_of[at] != start) continue;
        const std::uint32_t first = at;
        do {
            out.looped.push_back(at);
            at = out.parents[at];
        } while (at != first);
    }
    std::sort(out.looped.begin(), out.looped.end());
    return out;
}

Placement place(const Hierarchy& hierarchy) {
    const std::size_t count = hierarchy.parents.size();
    std::vector<std::vector<std::uint32_t>> children(count);
    for (std::uint32_t i = 0; i < count; ++i)
        if (hierarchy.parents[i] != Hierarchy::none) children[hierarchy.parents[i]].push_back(i);
    Placement out{.roots = std::vector<std::uint32_t>(count, Hierarchy::none),
                  .enter = std::vector<std::uint32_t>(count, 0),
                  .leave = std::vector<std::uint32_t>(count, 0),
                  .order = {}};
    for (std::uint32_t root = 0; root < count; ++root) {
        if (hierarchy.parents[root] != Hierarchy::none) continue;
        std::vector<std::uint32_t> stack{root};
        while (!stack.empty()) {
            const std::uint32_t node = stack.back();
            stack.pop_back();
            out.roots[node] = root;
            out.enter[node] = static_cast<std::uint32_t>(out.order.size());
            out.order.push_back(node);
            stack.insert(stack.end(), children[node].begin(), children[node].end());
        }
    }
    // From the last place to the first, every node's end is known before its parent asks for it.
    for (auto node = out.order.rbegin(); node != out.order.rend(); ++node) {
        out.leave[*node] = std::max(out.leave[*node], out.enter[*node] + 1);
        const std::uint32_t parent = hierarchy.parents[*node];
        if (parent != Hierarchy::none)
            out.leave[parent] = std::max(out.leave[parent], out.leave[*node]);
    }
    return out;
}

}  // namespace facet::scene::gltf
