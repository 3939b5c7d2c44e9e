// A mesh at one pose.
// SPDX-License-Identifier: MIT
#include "scene/deform.h"

#include "scene/tangents.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace facet::scene {
namespace {

void morph(const Shape& shape, std::span<const float> weights, Mesh& mesh) {
    for (std::size_t t = 0; t < shape.targets.size() && t < weights.size(); ++t) {
        const MorphTarget& target = shape.targets[t];
        const float weight = weights[t];
        if (weight == 0.0F || !std::isfinite(weight)) continue;
        for (std::size_t v = 0; v < target.positions_m.size(); ++v)
            mesh.positions_m[v] += weight * target.positions_m[v];
        if (!mesh.normals.empty())
            for (std::size_t v = 0; v < target.normals.size(); ++v)
                mesh.normals[v] += weight * target.normals[v];
        if (!mesh.tangents.empty())
            for (std::size_t v = 0; v < target.tangents.size(); ++v)
                mesh.tangents[v] += Vec4(weight * target.tangents[v], 0.0F);
    }
}

/// Moves vertices to where their joints are.
void skin(const Shape& shape, std::span<const Mat4> joints, Mesh& mesh) {
    for (std::size_t v = 0; v < mesh.positions_m.size(); ++v) {
        Mat4 matrix(0.0F);
        float sum = 0.0F;
        for (std::size_t i = v * shape.influence_count; i < (v + 1) * shape.influence_count; ++i) {
            if (shape.joint_weights[i] == 0.0F) continue;
            matrix += joints[shape.joints[i]] * shape.joint_weights[i];
            sum += shape.joint_weights[i];
        }
        if (sum == 0.0F) continue;
        mesh.positions_m[v] = Vec3(matrix * Vec4(mesh.positions_m[v], 1.0F));
        const Mat3 linear(matrix);
        if (!mesh.normals.empty() && glm::determinant(linear) != 0.0F)
            mesh.normals[v] = math::transpose(math::inverse(linear)) * mesh.normals[v];
        if (!mesh.tangents.empty())
            mesh.tangents[v] = Vec4(linear * Vec3(mesh.tangents[v]), mesh.tangents[v].w);
    }
}

bool is_finite(const Vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// How many triangles there were without area, or with a corner that joints or morph targets took
/// beyond all numbers.
std::size_t drop_degenerates(Mesh& mesh) {
    std::size_t kept = 0;
    for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
        const std::uint32_t a = mesh.indices[first];
        const std::uint32_t b = mesh.indices[first + 1];
        const std::uint32_t c = mesh.indices[first + 2];
        if (a == b || b == c || c == a) continue;
        const std::vector<Vec3>& p = mesh.positions_m;
        if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a]) continue;
        if (!is_finite(p[a]) || !is_finite(p[b]) || !is_finite(p[c])) continue;
        mesh.indices[kept] = a;
        mesh.indices[kept + 1] = b;
        mesh.indices[kept + 2] = c;
        kept += 3;
    }
    const std::size_t dropped = (mesh.indices.size() - kept) / 3;
    mesh.indices.resize(kept);
    return dropped;
}

/// `v` at length 1, whatever its scale: dividing by the largest part first keeps 1e-30 from
/// vanishing.
Vec3 unit_or_zero(const Vec3& v) {
    const float largest = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
    if (!(largest > 0.0F) || !std::isfinite(largest)) return Vec3(0.0F);
    const Vec3 unit = math::normalize(v / largest);
    return std::isfinite(unit.x) ? unit : Vec3(0.0F);  // fmax does not see a NaN
}

template <class T>
void spread(std::vector<T>& values, const std::vector<std::uint32_t>& indices) {
    if (values.empty()) return;
    std::vector<T> out;
    out.reserve(indices.size());
    for (const std::uint32_t i : indices) out.push_back(values[i]);
    values = std::move(out);
}

/// Gives every triangle three vertices of its own and its face normal.
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

/// Scales normals to 1; where one is zero or not finite, takes the mean of the faces around. How
/// many those were.
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

/// Given tangents of length 1 and w of 1 or -1; empty where one of them is none.
void mend_tangents(Mesh& mesh) {
    for (Vec4& tangent : mesh.tangents) {
        const Vec3 direction(tangent);
        const float size = math::length(direction);
        if (!(size > 1e-6F) || !std::isfinite(size)) {
            mesh.tangents.clear();
            return;
        }
        tangent = Vec4(direction / size, tangent.w < 0.0F ? -1.0F : 1.0F);
    }
}

/// Tangents only where the material needs them: given ones, else those of MikkTSpace.
void complete_tangents(const Material& material, Mesh& mesh) {
    if (!tangents_texture(material)) {
        mesh.tangents.clear();
        return;
    }
    mend_tangents(mesh);
    fill_tangents(mesh, material);
}

}  // namespace

Vec3 scaled_face_normal(const Mesh& mesh, std::size_t first) {
    const Vec3& a = mesh.positions_m[mesh.indices[first]];
    return math::cross(mesh.positions_m[mesh.indices[first + 1]] - a,
                       mesh.positions_m[mesh.indices[first + 2]] - a);
}

void mirror(Mesh& mesh) {
    for (std::size_t first = 0; first < mesh.indices.size(); first += 3)
        std::swap(mesh.indices[first + 1], mesh.indices[first + 2]);
    for (Vec4& tangent : mesh.tangents) tangent.w = -tangent.w;
}

Deformed deformed(Mesh undeformed, const Shape& shape, const Deformation& by,
                  const Material& material) {
    Deformed out{.mesh = std::move(undeformed)};
    Mesh& mesh = out.mesh;
    morph(shape, by.weights, mesh);
    if (!by.joints.empty()) skin(shape, by.joints, mesh);
    out.flat_triangles = drop_degenerates(mesh);
    if (mesh.indices.empty()) {
        out.mesh = {.name = std::move(mesh.name), .material = mesh.material};
        return out;
    }
    if (mesh.normals.empty())
        make_flat(mesh);
    else
        out.mended_normals = mend_normals(mesh);
    complete_tangents(material, mesh);
    mesh.is_mirrored = by.is_mirrored;
    if (by.is_mirrored) mirror(mesh);
    for (const Vec3& position : mesh.positions_m) mesh.bounds_m.add(position);
    return out;
}

}  // namespace facet::scene
