// Checks of nodes and scenes: a forest of trees, with transforms that mean something.
// SPDX-License-Identifier: MIT
#include "math/vector.h"
#include "scene/gltf/check.h"
#include "scene/gltf/hierarchy.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

namespace facet::scene::gltf {
namespace {

/// The validator's own tolerance for unit quaternions.
constexpr double unit_tolerance = 0.00769;

bool are_numbers(const Json* values, std::size_t count) {
    return values != nullptr && values->is_array() && values->size() == count &&
           std::all_of(values->begin(), values->end(), [](const Json& v) { return v.is_number(); });
}

void check_rotation(const Json& node, const std::string& where, Problems& problems) {
    const Json* const rotation = find(node, "rotation");
    if (!are_numbers(rotation, 4)) return;
    double square = 0;
    for (const Json& value : *rotation) square += value.get<double>() * value.get<double>();
    if (std::fabs(std::sqrt(square) - 1.0) > unit_tolerance)
        problems.error("ROTATION_NON_UNIT", where + "/rotation", "quaternion is not of length 1",
                       fmt::format("{}", std::sqrt(square)));
}

/// Whether a 4x4 matrix is a translation, a rotation and a scale: last row 0 0 0 1, columns square
/// to another.
bool is_decomposable(const Json& matrix) {
    std::array<double, 16> m{};
    for (std::size_t i = 0; i < 16; ++i) m[i] = matrix[i].get<double>();
    if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) return false;
    const auto column_dot = [&](std::size_t a, std::size_t b) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) sum += m[a * 4 + i] * m[b * 4 + i];
        return sum;
    };
    constexpr double tolerance = 1e-3;
    for (std::size_t a = 0; a < 3; ++a) {
        if (!(column_dot(a, a) > 0)) return false;
        for (std::size_t b = a + 1; b < 3; ++b)
            if (std::fabs(column_dot(a, b)) >
                tolerance * std::sqrt(column_dot(a, a) * column_dot(b, b)))
                return false;
    }
    return true;
}

void check_matrix(const Json& node, const std::string& where, Problems& problems) {
    const Json* const matrix = find(node, "matrix");
    if (matrix == nullptr) return;
    if (find(node, "translation") != nullptr || find(node, "rotation") != nullptr ||
        find(node, "scale") != nullptr)
        problems.error("NODE_MATRIX_TRS", where + "/matrix",
                       "node has a matrix and translation, rotation or scale");
    if (!are_numbers(matrix, 16)) return;
    if (!is_decomposable(*matrix))
        problems.error("NODE_MATRIX_NON_TRS", where + "/matrix",
                       "matrix is no translation, rotation and scale");
}

/// Whether every primitive of the mesh has joints.
bool is_skinned(const Json& mesh) {
    for (std::size_t p = 0; p < count_at(mesh, "primitives"); ++p)
        if (find_path(*element_at(mesh, "primitives", p), "attributes/JOINTS_0") == nullptr)
            return false;
    return count_at(mesh, "primitives") > 0;
}

void check_node_mesh(const Json& json, const Json& node, const std::string& where,
                     Problems& problems) {
    const auto index = index_at(node, "mesh");
    const Json* const mesh = index ? element_at(json, "meshes", *index) : nullptr;
    if (mesh == nullptr || count_at(*mesh, "primitives") == 0) return;
    const bool has_skin = find(node, "skin") != nullptr;
    if (has_skin && !is_skinned(*mesh))
        problems.error("NODE_SKIN_WITH_NON_SKINNED_MESH", where,
                       "node has a skin, but its mesh no joints");
    if (!has_skin && is_skinned(*mesh))
        problems.note(Severity::warning, "NODE_SKINNED_MESH_WITHOUT_SKIN", where,
                      "mesh has joints, but its node no skin");
    const std::size_t targets = count_at(*element_at(*mesh, "primitives", 0), "targets");
    const std::size_t weights = count_at(node, "weights");
    if (weights > 0 && weights != targets)
        problems.error("NODE_WEIGHTS_INVALID", where + "/weights",
                       "number of weights differs from that of morph targets",
                       fmt::format("{}, but there are {}", weights, targets));
}

void check_emptiness(const Json& node, const std::string& where, Problems& problems) {
    for (const char* const key : {"children", "mesh", "camera", "skin", "extensions", "matrix",
                                  "translation", "rotation", "scale", "name", "weights"})
        if (find(node, key) != nullptr) return;
    problems.note(Severity::information, "NODE_EMPTY", where, "node is empty");
}

void check_loops(const Hierarchy& hierarchy, Problems& problems) {
    for (const std::uint32_t index : hierarchy.looped) {
        std::string chain = std::to_string(index);
        std::uint32_t at = hierarchy.parents[index];
        for (int shown = 0; at != index && at != Hierarchy::none && shown < 8; ++shown) {
            chain = std::to_string(at) + " -> " + chain;
            at = hierarchy.parents[at];
        }
        problems.error("NODE_LOOP", pointer_text("nodes", index), "node is its own ancestor",
                       std::to_string(index) + " -> " + chain);
    }
}

void check_scene(const Json& json, const Hierarchy& hierarchy, std::size_t index,
                 Problems& problems) {
    const Json& scene = *element_at(json, "scenes", index);
    for (std::size_t n = 0; n < count_at(scene, "nodes"); ++n) {
        const auto node = as_unsigned(*element_at(scene, "nodes", n));
        if (node && *node < hierarchy.parents.size() && hierarchy.parents[*node] != Hierarchy::none)
            problems.error("SCENE_NON_ROOT_NODE", fmt::format("/scenes/{}/nodes/{}", index, n),
                           "a node of the scene is another node's child",
                           fmt::format("{} -> {}", hierarchy.parents[*node], *node));
    }
}

}  // namespace

void check_nodes(const Asset& asset, Problems& problems) {
    for (std::size_t i = 0; i < count_at(asset.json, "nodes"); ++i) {
        const Json& node = *element_at(asset.json, "nodes", i);
        const std::string where = pointer_text("nodes", i);
        check_rotation(node, where, problems);
        check_matrix(node, where, problems);
        check_node_mesh(asset.json, node, where, problems);
        if (node.is_object()) check_emptiness(node, where, problems);
        if (find_path(node, "extensions/KHR_lights_punctual") != nullptr &&
            find_path(asset.json, "extensions/KHR_lights_punctual") == nullptr)
            problems.error("UNSATISFIED_DEPENDENCY", where + "/extensions/KHR_lights_punctual",
                           "'/extensions/KHR_lights_punctual' must be defined as well");
    }
    const Hierarchy hierarchy = read_hierarchy(asset.json, &problems);
    check_loops(hierarchy, problems);
    for (std::size_t i = 0; i < count_at(asset.json, "scenes"); ++i)
        check_scene(asset.json, hierarchy, i, problems);
}

}  // namespace facet::scene::gltf
