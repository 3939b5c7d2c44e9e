// Tangents for normal maps, as MikkTSpace defines them.
// SPDX-License-Identifier: MIT
#include "scene/tangents.h"

#include "base/assert.h"
#include "scene/lobes.h"
#include "scene/relief.h"
#include "scene/tangents_topology.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace facet::scene {
namespace {

constexpr std::uint32_t none = tangents::none;

/// What one triangle says about the directions of u and of v.
struct Face {
    Vec3 along_u{0.0F};            ///< unit, or zero
    bool is_right_handed = false;  ///< orientation of the coordinates is kept
    bool follows_any = true;  ///< no area in uv: takes the handedness of whatever group reaches it
    bool is_degenerate = false;  ///< no area in space
};

struct Work {
    const Mesh& mesh;
    const std::vector<Vec2>& uv;
    std::vector<std::uint32_t> weld;  ///< by vertex: first vertex that equals it
    std::vector<Face> faces;
    std::vector<std::uint32_t> neighbors;  ///< by corner: corner across the edge that starts here
    std::vector<std::uint32_t> groups;     ///< by corner
    std::vector<Vec3> sums;                ///< by group
    std::vector<bool> group_is_right_handed;
};

bool is_usable(float x) { return std::fabs(x) > std::numeric_limits<float>::min(); }

Vec3 normalized_or_zero(const Vec3& v) {
    const float size = math::length(v);
    return is_usable(size) ? v / size : Vec3(0.0F);
}

std::uint32_t next_corner(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}
std::uint32_t previous_corner(std::uint32_t corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

Face describe_face(const Work& work, std::size_t first) {
    std::array<std::uint32_t, 3> v{};
    for (std::size_t i = 0; i < 3; ++i) v[i] = work.mesh.indices[first + i];
    const std::vector<Vec3>& p = work.mesh.positions_m;
    Face face;
    face.is_degenerate = p[v[0]] == p[v[1]] || p[v[1]] == p[v[2]] || p[v[2]] == p[v[0]];
    const Vec3 d1 = p[v[1]] - p[v[0]];
    const Vec3 d2 = p[v[2]] - p[v[0]];
    Vec2 t1 = work.uv[v[1]] - work.uv[v[0]];
    Vec2 t2 = work.uv[v[2]] - work.uv[v[0]];
    t1.y = -t1.y;  // MikkTSpace's v points up, glTF's down
    t2.y = -t2.y;
    const float area2 = t1.x * t2.y - t1.y * t2.x;
    face.is_right_handed = area2 > 0.0F;
    if (!is_usable(area2)) return face;
    const float sign = face.is_right_handed ? 1.0F : -1.0F;
    const Vec3 along_u = d1 * t2.y - d2 * t1.y;
    const Vec3 along_v = d2 * t1.x - d1 * t2.x;
    face.along_u = normalized_or_zero(along_u) * sign;
    face.follows_any = !is_usable(math::length(along_u)) || !is_usable(math::length(along_v));
    return face;
}

/// Whether `corner` may join a group; a face that follows any takes the handedness of the first.
bool admit(Work& work, std::uint32_t corner, bool is_right_handed) {
    Face& face = work.faces[corner / 3];
    if (face.is_degenerate || work.groups[corner] != none) return false;
    const std::uint32_t first = corner / 3 * 3;
    const bool is_free = work.groups[first] == none && work.groups[first + 1] == none &&
                         work.groups[first + 2] == none;
    if (face.follows_any && is_free) face.is_right_handed = is_right_handed;
    return face.is_right_handed == is_right_handed;
}

/// Floods from corner to corner around one vertex, over shared edges.
void grow_group(Work& work, std::uint32_t seed, std::uint32_t group,
                std::vector<std::uint32_t>& stack) {
    const bool is_right_handed = work.faces[seed / 3].is_right_handed;
    const std::uint32_t vertex = work.weld[work.mesh.indices[seed]];
    stack.assign(1, seed);
    while (!stack.empty()) {
        const std::uint32_t corner = stack.back();
        stack.pop_back();
        if (!admit(work, corner, is_right_handed)) continue;
        work.groups[corner] = group;
        // The edge that leaves this corner ends at it in the neighbour, and the other way round.
        const std::uint32_t across_out = work.neighbors[corner];
        const std::uint32_t across_in = work.neighbors[previous_corner(corner)];
        for (const std::uint32_t start : {across_out, across_in}) {
            if (start == none) continue;
            const bool is_start = work.weld[work.mesh.indices[start]] == vertex;
            stack.push_back(is_start ? start : next_corner(start));
        }
    }
}

void build_groups(Work& work) {
    const auto corner_count = static_cast<std::uint32_t>(work.mesh.indices.size());
    work.groups.assign(corner_count, none);
    std::vector<std::uint32_t> stack;
    for (std::uint32_t corner = 0; corner < corner_count; ++corner) {
        const Face& face = work.faces[corner / 3];
        if (face.follows_any || face.is_degenerate || work.groups[corner] != none) continue;
        const auto group = static_cast<std::uint32_t>(work.group_is_right_handed.size());
        work.group_is_right_handed.push_back(face.is_right_handed);
        grow_group(work, corner, group, stack);
    }
}

/// Adds what a corner's face says, weighted by the angle it spans around the normal.
void add_corner(Work& work, std::uint32_t corner) {
    const std::uint32_t group = work.groups[corner];
    const Face& face = work.faces[corner / 3];
    if (group == none || face.follows_any) return;
    const std::uint32_t vertex = work.mesh.indices[corner];
    const Vec3& n = work.mesh.normals[vertex];
    const auto in_plane = [&](const Vec3& v) {
        return normalized_or_zero(v - n * math::dot(n, v));
    };
    const Vec3& here = work.mesh.positions_m[vertex];
    const Vec3 back =
        in_plane(work.mesh.positions_m[work.mesh.indices[previous_corner(corner)]] - here);
    const Vec3 ahead =
        in_plane(work.mesh.positions_m[work.mesh.indices[next_corner(corner)]] - here);
    const float angle = std::acos(std::clamp(math::dot(back, ahead), -1.0F, 1.0F));
    work.sums[group] += in_plane(face.along_u) * angle;
}

Vec4 any_tangent(const Vec3& n) {
    const Vec3 axis = std::fabs(n.x) < 0.9F ? Vec3(1.0F, 0.0F, 0.0F) : Vec3(0.0F, 1.0F, 0.0F);
    const Vec3 t = normalized_or_zero(axis - n * math::dot(n, axis));
    return {t == Vec3(0.0F) ? axis : t, 1.0F};
}

Vec4 corner_tangent(const Work& work, std::uint32_t corner) {
    const std::uint32_t group = work.groups[corner];
    const Vec3& n = work.mesh.normals[work.mesh.indices[corner]];
    if (group == none || work.sums[group] == Vec3(0.0F)) return any_tangent(n);
    return {work.sums[group], work.group_is_right_handed[group] ? 1.0F : -1.0F};
}

/// Corners of degenerate faces, and of faces no group reached, borrow the group of an equal vertex.
void lend_groups(Work& work) {
    std::vector<std::uint32_t> lender(work.weld.size(), none);
    for (std::size_t c = 0; c < work.groups.size(); ++c)
        if (work.groups[c] != none) {
            std::uint32_t& slot = lender[work.weld[work.mesh.indices[c]]];
            if (slot == none) slot = work.groups[c];
        }
    for (std::size_t c = 0; c < work.groups.size(); ++c)
        if (work.groups[c] == none) work.groups[c] = lender[work.weld[work.mesh.indices[c]]];
}

template <class T>
void repeat_last(std::vector<T>& values, std::uint32_t source) {
    if (values.empty()) return;
    const T copy = values[source];
    values.push_back(copy);
}

/// Gives each corner its tangent; a vertex that is asked for a second one is copied.
void split_vertices(Mesh& mesh, const std::vector<Vec4>& by_corner) {
    const std::size_t original_count = mesh.positions_m.size();
    std::vector<std::uint32_t> next_copy(original_count, none);
    std::vector<bool> is_set(original_count, false);
    mesh.tangents.assign(original_count, Vec4(0.0F));
    for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
        std::uint32_t vertex = mesh.indices[corner];
        while (is_set[vertex] && mesh.tangents[vertex] != by_corner[corner] &&
               next_copy[vertex] != none)
            vertex = next_copy[vertex];
        if (is_set[vertex] && mesh.tangents[vertex] != by_corner[corner]) {
            const auto copy = static_cast<std::uint32_t>(mesh.positions_m.size());
            for (std::vector<Vec3>* const values : {&mesh.positions_m, &mesh.normals})
                repeat_last(*values, vertex);
            for (std::vector<Vec2>* const values : {&mesh.uv0, &mesh.uv1})
                repeat_last(*values, vertex);
            for (std::vector<Vec4>* const values : {&mesh.colors, &mesh.tangents})
                repeat_last(*values, vertex);
            next_copy[vertex] = copy;
            next_copy.push_back(none);
            is_set.push_back(false);
            vertex = copy;
        }
        mesh.tangents[vertex] = by_corner[corner];
        is_set[vertex] = true;
        mesh.indices[corner] = vertex;
    }
    for (std::size_t v = 0; v < mesh.tangents.size(); ++v)  // vertices that no triangle uses
        if (!is_set[v]) mesh.tangents[v] = any_tangent(mesh.normals[v]);
}

/// As a lathe brushes: level, and square to the normal.
Vec4 around_axis(const Vec3& normal) {
    const Vec3 along = normalized_or_zero(math::cross(Vec3(0.0F, 1.0F, 0.0F), normal));
    return {along == Vec3(0.0F) ? Vec3(1.0F, 0.0F, 0.0F) : along, 1.0F};
}

}  // namespace

void generate_tangents(Mesh& mesh, std::uint32_t uv_set) {
    const std::vector<Vec2>& uv = mesh.uv(uv_set);
    FACET_ASSERT(uv.size() == mesh.positions_m.size() &&
                 mesh.normals.size() == mesh.positions_m.size());
    Work work{.mesh = mesh,
              .uv = uv,
              .weld = tangents::weld_vertices(mesh, uv),
              .faces = {},
              .neighbors = {},
              .groups = {},
              .sums = {},
              .group_is_right_handed = {}};
    for (std::size_t first = 0; first < mesh.indices.size(); first += 3)
        work.faces.push_back(describe_face(work, first));
    work.neighbors = tangents::find_neighbors(mesh.indices, work.weld);
    build_groups(work);
    work.sums.assign(work.group_is_right_handed.size(), Vec3(0.0F));
    const auto corner_count = static_cast<std::uint32_t>(mesh.indices.size());
    for (std::uint32_t corner = 0; corner < corner_count; ++corner) add_corner(work, corner);
    for (Vec3& sum : work.sums) sum = normalized_or_zero(sum);
    lend_groups(work);
    std::vector<Vec4> by_corner(corner_count);
    for (std::uint32_t corner = 0; corner < corner_count; ++corner)
        by_corner[corner] = corner_tangent(work, corner);
    split_vertices(mesh, by_corner);
}

std::optional<Texture> tangents_texture(const Material& material) {
    for (std::size_t slot = 0; slot < material.textures.size(); ++slot)
        if (material.textures[slot] && tables::material_textures[slot].is_normal_map)
            return material.textures[slot];
    if (!has_lobe(material, tables::Lobe::anisotropy)) return std::nullopt;
    return material.texture(tables::TextureSlot::anisotropy_texture).value_or(Texture{});
}

void fill_tangents(Mesh& mesh, const Material& material) {
    const auto texture = tangents_texture(material);
    if (!texture || !mesh.tangents.empty()) return;
    if (!mesh.uv(texture->uv_set).empty()) {
        generate_tangents(mesh, texture->uv_set);
    } else if (has_lobe(material, tables::Lobe::anisotropy)) {
        mesh.tangents.reserve(mesh.normals.size());
        for (const Vec3& normal : mesh.normals) mesh.tangents.push_back(around_axis(normal));
    }
}

void generate_missing_tangents(Scene& scene) {
    for (Mesh& mesh : scene.meshes) {
        const Material& material = scene.materials[mesh.material.index];
        if (!mesh.tangents.empty() || !tangents_texture(material)) continue;
        lower_relief(mesh);  // the next one is of a mesh with tangents
        fill_tangents(mesh, material);
    }
}

}  // namespace facet::scene
