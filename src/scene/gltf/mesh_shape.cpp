// Triangles out of a primitive's mode and indices, and what a mesh lacks computed from them.
// SPDX-License-Identifier: MIT
#include "scene/gltf/elements.h"
#include "scene/gltf/mesh.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace facet::scene::gltf {
namespace {

using base::ErrorCode;

std::uint32_t restart_value(Component component) {
    if (component == Component::u8) return std::numeric_limits<std::uint8_t>::max();
    if (component == Component::u16) return std::numeric_limits<std::uint16_t>::max();
    return std::numeric_limits<std::uint32_t>::max();
}

base::Result<std::vector<std::uint32_t>> read_indices(const Import& import,
                                                      const tinygltf::Primitive& primitive,
                                                      std::size_t vertex_count,
                                                      const std::string& where) {
    std::vector<std::uint32_t> indices;
    if (primitive.indices < 0) {
        indices.resize(vertex_count);
        std::iota(indices.begin(), indices.end(), 0U);
        return indices;
    }
    const auto index = static_cast<std::size_t>(primitive.indices);
    if (index >= import.asset.accessors.size() || !import.asset.accessors[index].is_sound)
        return base::fail({.code = ErrorCode::input_invalid,
                           .where = where + "/indices",
                           .what = "indices cannot be read"});
    const Accessor& accessor = import.asset.accessors[index];
    indices = read_unsigned(accessor);
    const std::uint32_t restart = restart_value(accessor.component);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] < vertex_count) continue;
        return base::fail(
            {.code = ErrorCode::input_invalid,
             .where = where + "/indices",
             .what = indices[i] == restart ? "index is the primitive restart value"
                                           : "index out of range",
             .found = fmt::format("{} at {}, but there are {}", indices[i], i, vertex_count),
             .remedy = "export the model again"});
    }
    return indices;
}

/// Corners of the triangles of a strip or fan (glTF 2.0, section 3.7.2.1).
std::vector<std::uint32_t> unroll(std::span<const std::uint32_t> in, bool is_fan) {
    std::vector<std::uint32_t> out;
    if (in.size() < 3) return out;
    out.reserve((in.size() - 2) * 3);
    for (std::size_t i = 0; i + 2 < in.size(); ++i) {
        if (is_fan)
            out.insert(out.end(), {in[i + 1], in[i + 2], in[0]});
        else
            out.insert(out.end(), {in[i], in[i + 1 + i % 2], in[i + 2 - i % 2]});
    }
    return out;
}

Vec3 scaled_face_normal(const Mesh& mesh, std::size_t first) {
    const Vec3& a = mesh.positions_m[mesh.indices[first]];
    return math::cross(mesh.positions_m[mesh.indices[first + 1]] - a,
                       mesh.positions_m[mesh.indices[first + 2]] - a);
}

/// `v` at length 1, whatever its scale: dividing by the largest part first keeps 1e-30 from
/// vanishing.
Vec3 unit_or_zero(const Vec3& v) {
    const float largest = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
    if (!(largest > 0.0F) || !std::isfinite(largest)) return Vec3(0.0F);
    return math::normalize(v / largest);
}

template <class T>
void spread(std::vector<T>& values, const std::vector<std::uint32_t>& indices) {
    if (values.empty()) return;
    std::vector<T> out;
    out.reserve(indices.size());
    for (const std::uint32_t i : indices) out.push_back(values[i]);
    values = std::move(out);
}

}  // namespace

base::Result<std::vector<std::uint32_t>> read_triangles(Import& import,
                                                        const tinygltf::Primitive& primitive,
                                                        std::size_t vertex_count,
                                                        const std::string& where) {
    auto indices = read_indices(import, primitive, vertex_count, where);
    if (!indices) return indices;
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP) return unroll(*indices, false);
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) return unroll(*indices, true);
    const std::size_t tail = indices->size() % 3;
    if (tail != 0) {
        import.warn(where, "count is not a multiple of 3, the last vertices are dropped",
                    std::to_string(indices->size()));
        indices->resize(indices->size() - tail);
    }
    return indices;
}

std::size_t drop_degenerates(Mesh& mesh) {
    std::size_t kept = 0;
    for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
        const std::uint32_t a = mesh.indices[first];
        const std::uint32_t b = mesh.indices[first + 1];
        const std::uint32_t c = mesh.indices[first + 2];
        if (a == b || b == c || c == a) continue;
        const std::vector<Vec3>& p = mesh.positions_m;
        if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a]) continue;
        mesh.indices[kept] = a;
        mesh.indices[kept + 1] = b;
        mesh.indices[kept + 2] = c;
        kept += 3;
    }
    const std::size_t dropped = (mesh.indices.size() - kept) / 3;
    mesh.indices.resize(kept);
    return dropped;
}

void make_flat(Mesh& mesh) {
    spread(mesh.positions_m, mesh.indices);
    spread(mesh.uv0, mesh.indices);
    spread(mesh.uv1, mesh.indices);
    spread(mesh.colors, mesh.indices);
    mesh.tangents
        .clear();  // without normals, given tangents are to be ignored (glTF 2.0, section 3.7.2.1)
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0U);
    mesh.normals.resize(mesh.positions_m.size());
    for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
        const Vec3 n = unit_or_zero(scaled_face_normal(mesh, first));
        for (std::size_t i = 0; i < 3; ++i)
            mesh.normals[first + i] = n == Vec3(0.0F) ? Vec3(0.0F, 1.0F, 0.0F) : n;
    }
}

std::size_t mend_normals(Mesh& mesh) {
    std::vector<std::uint32_t> broken;
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
        mesh.normals[v] = unit_or_zero(mesh.normals[v]);
        if (mesh.normals[v] == Vec3(0.0F)) broken.push_back(static_cast<std::uint32_t>(v));
    }
    if (broken.empty()) return 0;
    std::vector<Vec3> sums(mesh.normals.size(), Vec3(0.0F));
    for (std::size_t first = 0; first < mesh.indices.size(); first += 3)
        for (std::size_t i = 0; i < 3; ++i)
            sums[mesh.indices[first + i]] += scaled_face_normal(mesh, first);
    for (const std::uint32_t v : broken) {
        const Vec3 n = unit_or_zero(sums[v]);
        mesh.normals[v] = n == Vec3(0.0F) ? Vec3(0.0F, 1.0F, 0.0F) : n;
    }
    return broken.size();
}

void mirror(Mesh& mesh) {
    for (std::size_t first = 0; first < mesh.indices.size(); first += 3)
        std::swap(mesh.indices[first + 1], mesh.indices[first + 2]);
    for (Vec4& tangent : mesh.tangents) tangent.w = -tangent.w;
}

}  // namespace facet::scene::gltf
