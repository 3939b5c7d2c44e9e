// Points and lines as thin bodies.
// SPDX-License-Identifier: MIT
#include "scene/gltf/points_and_lines.h"

#include "scene/gltf/elements.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace facet::scene::gltf {
namespace {

/// The body of one point or line: its vertices lie around their own, `offset` radii away.
struct BodyVertex {
    std::uint32_t end = 0;  ///< of the line: 0 or 1
    Vec3 offset{0.0F};      ///< along two sides and the line
};
constexpr std::array<Vec3, 4> ring{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)};

/// A tip, a ring at each end, a tip.
std::vector<BodyVertex> tube_vertices() {
    std::vector<BodyVertex> out{{0, Vec3(0, 0, -1)}};
    for (const std::uint32_t end : {0U, 1U})
        for (const Vec3& side : ring) out.push_back({end, side});
    out.push_back({1, Vec3(0, 0, 1)});
    return out;
}
/// Counter-clockwise is outside where sides and line are right-handed.
std::vector<std::uint32_t> tube_triangles() {
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t a = 1 + i;
        const std::uint32_t a_next = 1 + (i + 1) % 4;
        out.insert(out.end(), {a_next, a, 0});
        out.insert(out.end(), {a, a_next, a_next + 4, a, a_next + 4, a + 4});
        out.insert(out.end(), {a + 4, a_next + 4, 9});
    }
    return out;
}
/// A tube without its length.
std::vector<BodyVertex> octahedron_vertices() {
    std::vector<BodyVertex> out{{0, Vec3(0, 0, -1)}};
    for (const Vec3& side : ring) out.push_back({0, side});
    out.push_back({0, Vec3(0, 0, 1)});
    return out;
}
std::vector<std::uint32_t> octahedron_triangles() {
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t a = 1 + i;
        const std::uint32_t next = 1 + (i + 1) % 4;
        out.insert(out.end(), {next, a, 0, a, next, 5});
    }
    return out;
}

/// Ends of every line; of a point twice the same.
using Ends = std::vector<std::array<std::uint32_t, 2>>;

Ends ends_of(int mode, std::span<const std::uint32_t> in) {
    Ends out;
    if (draws_points(mode)) {
        for (const std::uint32_t i : in) out.push_back({i, i});
        return out;
    }
    const std::size_t step = mode == TINYGLTF_MODE_LINE ? 2 : 1;
    for (std::size_t i = 0; i + 1 < in.size(); i += step) out.push_back({in[i], in[i + 1]});
    if (mode == TINYGLTF_MODE_LINE_LOOP && in.size() > 2) out.push_back({in.back(), in.front()});
    return out;
}

/// Right-handed: two sides, then along the line; of a line without length, any.
Mat3 frame_along(const Vec3& line) {
    const float size = math::length(line);
    const Vec3 t = size > 0.0F && std::isfinite(size) ? line / size : Vec3(0.0F, 0.0F, 1.0F);
    const Vec3 spare = std::fabs(t.y) < 0.9F ? Vec3(0.0F, 1.0F, 0.0F) : Vec3(1.0F, 0.0F, 0.0F);
    const Vec3 u = math::normalize(math::cross(spare, t));
    return {u, math::cross(t, u), t};
}

/// Every vertex made, by the one that it is made of.
template <class T>
void take_from(std::vector<T>& values, const std::vector<std::uint32_t>& sources,
               std::size_t width = 1) {
    if (values.empty()) return;
    std::vector<T> out;
    out.reserve(sources.size() * width);
    for (const std::uint32_t source : sources)
        for (std::size_t i = 0; i < width; ++i) out.push_back(values[source * width + i]);
    values = std::move(out);
}

/// Memory for bodies in place of the shape's vertices. Errors: limit_reached.
base::Status take_bodies(Import& import, const Shape& shape, std::size_t body_count,
                         std::size_t vertex_count, std::size_t index_count,
                         const std::string& where) {
    if (body_count > import.limits.vertices / vertex_count)
        return base::fail({.code = base::ErrorCode::limit_reached,
                           .where = where,
                           .what = "points or lines take too many vertices",
                           .found = fmt::format("{} of {} each, limit {}", body_count, vertex_count,
                                                import.limits.vertices),
                           .remedy = "raise --max-vertices"});
    std::size_t bytes = vertex_bytes;
    for (const MorphTarget& target : shape.targets)
        if (!target.positions_m.empty() || !target.normals.empty() || !target.tangents.empty())
            bytes += 3 * sizeof(Vec3);
    return import.take_memory(
        body_count * (vertex_count * bytes + index_count * sizeof(std::uint32_t)), where);
}

/// Whether some primitive of the mesh has points or lines.
bool has_lines(const tinygltf::Mesh& mesh) {
    return std::any_of(
        mesh.primitives.begin(), mesh.primitives.end(),
        [](const tinygltf::Primitive& p) { return draws_points(p.mode) || draws_lines(p.mode); });
}

math::Bounds bounds_of(const Import& import, std::size_t index) {
    math::Bounds bounds;
    if (index >= import.asset.accessors.size()) return bounds;
    const Accessor& accessor = import.asset.accessors[index];
    // What there is no memory for will be refused when it is read to be kept.
    if (!accessor.is_sound || accessor.components != 3 ||
        accessor.count > import.asset.memory_left / sizeof(Vec3))
        return bounds;
    const std::vector<float> p = read_floats(accessor);
    for (std::size_t i = 0; i + 2 < p.size(); i += 3)
        if (std::isfinite(p[i]) && std::isfinite(p[i + 1]) && std::isfinite(p[i + 2]))
            bounds.add(Vec3(p[i], p[i + 1], p[i + 2]));
    return bounds;
}

/// The box around a mesh. `known`: those of accessors, which primitives may share.
math::Bounds bounds_of(const Import& import, const tinygltf::Mesh& mesh,
                       std::map<std::size_t, math::Bounds>& known) {
    math::Bounds bounds;
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
        const auto found = primitive.attributes.find("POSITION");
        if (found == primitive.attributes.end() || found->second < 0) continue;
        const auto [box, is_new] = known.try_emplace(static_cast<std::size_t>(found->second));
        if (is_new) box->second = bounds_of(import, box->first);
        if (box->second.is_empty()) continue;
        bounds.add(box->second.low);
        bounds.add(box->second.high);
    }
    return bounds;
}

void add_corners(const math::Bounds& box, const Mat4& world, math::Bounds& to) {
    for (unsigned corner = 0; corner < 8 && !box.is_empty(); ++corner)
        to.add(Vec3(world * Vec4((corner & 1U) != 0 ? box.high.x : box.low.x,
                                 (corner & 2U) != 0 ? box.high.y : box.low.y,
                                 (corner & 4U) != 0 ? box.high.z : box.low.z, 1.0F)));
}

}  // namespace

void measure_lines(Import& import, std::span<const std::uint32_t> shown,
                   std::span<const Mat4> world_from_node) {
    const auto& meshes = import.model.meshes;
    if (std::none_of(meshes.begin(), meshes.end(), has_lines)) return;
    std::map<std::size_t, math::Bounds> accessor_boxes;
    std::vector<std::optional<math::Bounds>> boxes(meshes.size());
    std::vector<float> scales(meshes.size(), 0.0F);  // the largest that a mesh is placed with
    math::Bounds scene;
    for (const std::uint32_t index : shown) {
        const tinygltf::Node& node = import.model.nodes[index];
        if (node.mesh < 0) continue;
        const auto mesh = static_cast<std::size_t>(node.mesh);
        if (!boxes[mesh]) boxes[mesh] = bounds_of(import, meshes[mesh], accessor_boxes);
        const Mat4 world = node.skin >= 0 ? Mat4(1.0F) : world_from_node[index];
        add_corners(*boxes[mesh], world, scene);
        scales[mesh] = std::max(scales[mesh], std::cbrt(std::fabs(glm::determinant(Mat3(world)))));
    }
    const float size = scene.is_empty() ? 0.0F : math::length(scene.high - scene.low);
    import.line_scales.resize(meshes.size());
    for (std::size_t m = 0; m < meshes.size(); ++m)
        // One point alone has no size to take a share of.
        import.line_scales[m] = (size > 0.0F && std::isfinite(size) ? size : 1.0F) /
                                (scales[m] > 0.0F && std::isfinite(scales[m]) ? scales[m] : 1.0F);
}

base::Status thicken(Import& import, std::size_t mesh_index, const tinygltf::Primitive& primitive,
                     const std::string& where, Shape& shape) {
    Mesh& mesh = shape.mesh;
    const auto indices = read_indices(import, primitive, mesh.positions_m.size(), where);
    if (!indices) return base::fail(indices.error());
    const bool is_point = draws_points(primitive.mode);
    if (primitive.mode == TINYGLTF_MODE_LINE && indices->size() % 2 != 0)
        import.warn(where, "count is not a multiple of 2, the last vertex is dropped",
                    std::to_string(indices->size()));
    const Ends ends = ends_of(primitive.mode, *indices);
    const auto vertices = is_point ? octahedron_vertices() : tube_vertices();
    const auto triangles = is_point ? octahedron_triangles() : tube_triangles();
    if (auto taken =
            take_bodies(import, shape, ends.size(), vertices.size(), triangles.size(), where);
        !taken)
        return taken;
    const float radius =
        0.5F * (is_point ? point_width_share : line_width_share) * import.line_scales[mesh_index];
    std::vector<std::uint32_t> sources;
    std::vector<Vec3> positions_m;
    std::vector<Vec3> outwards;
    sources.reserve(ends.size() * vertices.size());
    mesh.indices.clear();
    for (const auto& [from, to] : ends) {
        const auto first = static_cast<std::uint32_t>(sources.size());
        const Mat3 frame = frame_along(mesh.positions_m[to] - mesh.positions_m[from]);
        for (const BodyVertex& vertex : vertices) {
            const std::uint32_t source = vertex.end == 0 ? from : to;
            sources.push_back(source);
            outwards.push_back(frame * vertex.offset);
            positions_m.push_back(mesh.positions_m[source] + radius * outwards.back());
        }
        for (const std::uint32_t corner : triangles) mesh.indices.push_back(first + corner);
    }
    mesh.positions_m = std::move(positions_m);
    const bool has_normals = !mesh.normals.empty();
    if (has_normals)
        take_from(mesh.normals, sources);
    else
        mesh.normals = std::move(outwards);
    take_from(mesh.tangents, sources);
    take_from(mesh.uv0, sources);
    take_from(mesh.uv1, sources);
    take_from(mesh.colors, sources);
    take_from(shape.joints, sources, shape.influence_count);
    take_from(shape.joint_weights, sources, shape.influence_count);
    for (MorphTarget& target : shape.targets) {
        take_from(target.positions_m, sources);
        if (!has_normals) target.normals.clear();  // of normals that are not there
        take_from(target.normals, sources);
        take_from(target.tangents, sources);
    }
    return {};
}

MaterialId unlit_material(Import& import, MaterialId id) {
    if (import.scene.materials[id.index].unlit) return id;
    const MaterialId next{static_cast<std::uint32_t>(import.scene.materials.size())};
    const auto [known, is_new] = import.unlit_materials.try_emplace(id.index, next);
    if (!is_new) return known->second;
    Material unlit = import.scene.materials[id.index];
    unlit.unlit = true;
    import.scene.materials.push_back(std::move(unlit));
    return next;
}

}  // namespace facet::scene::gltf
