// Meshes as one vertex buffer and one index buffer.
// SPDX-License-Identifier: MIT
#include "frame/upload/upload_meshes.h"

#include "gl/pipeline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace facet::frame {
namespace {

/// 16 bits a component keep a mirror's reflection straight; 10 bits show as bands.
struct Vertex {
    math::Vec3 position_m;
    std::array<std::int16_t, 4> normal;
    std::array<std::int16_t, 4> tangent;
    math::Vec2 uv0;
    math::Vec2 uv1;
    std::array<std::uint8_t, 4> color;
};
static_assert(sizeof(Vertex) == 48);

std::int16_t snorm16(float x) {
    return static_cast<std::int16_t>(std::lround(std::clamp(x, -1.0F, 1.0F) * 32767.0F));
}
std::uint8_t unorm8(float x) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0F, 1.0F) * 255.0F));
}
std::array<std::int16_t, 4> packed(const math::Vec4& v) {
    return {snorm16(v.x), snorm16(v.y), snorm16(v.z), snorm16(v.w)};
}

Vertex vertex_of(const scene::Mesh& mesh, std::size_t i) {
    Vertex v{};
    v.position_m = mesh.positions_m[i];
    v.normal = packed(math::Vec4(mesh.normals[i], 0.0F));
    if (!mesh.tangents.empty()) v.tangent = packed(mesh.tangents[i]);
    if (!mesh.uv0.empty()) v.uv0 = mesh.uv0[i];
    if (!mesh.uv1.empty()) v.uv1 = mesh.uv1[i];
    const math::Vec4 color = mesh.colors.empty() ? math::Vec4(1.0F) : mesh.colors[i];
    v.color = {unorm8(color.x), unorm8(color.y), unorm8(color.z), unorm8(color.w)};
    return v;
}

void describe_vertices(const gl::Context& gl, GpuScene& out) {
    const gl::Api& api = gl.api();
    api.BindVertexArray(out.vertex_array.name());
    api.BindBuffer(GL_ARRAY_BUFFER, out.vertices.name());
    api.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, out.indices.name());
    struct Attribute {
        GLint size;
        GLenum type;
        GLboolean normalized;
        std::size_t offset;
    };
    const std::array attributes = {
        Attribute{3, GL_FLOAT, GL_FALSE, offsetof(Vertex, position_m)},
        Attribute{3, GL_SHORT, GL_TRUE, offsetof(Vertex, normal)},
        Attribute{4, GL_SHORT, GL_TRUE, offsetof(Vertex, tangent)},
        Attribute{2, GL_FLOAT, GL_FALSE, offsetof(Vertex, uv0)},
        Attribute{2, GL_FLOAT, GL_FALSE, offsetof(Vertex, uv1)},
        Attribute{4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Vertex, color)},
    };
    for (GLuint i = 0; i < attributes.size(); ++i) {
        api.EnableVertexAttribArray(i);
        api.VertexAttribPointer(i, attributes[i].size, attributes[i].type, attributes[i].normalized,
                                sizeof(Vertex),
                                reinterpret_cast<const void*>(attributes[i].offset));
    }
}

}  // namespace

void upload_meshes(const gl::Context& gl, const scene::Scene& scene, base::ThreadPool& pool,
                   GpuScene& out) {
    std::vector<MeshRange>& ranges = out.mesh_ranges;
    ranges.clear();
    std::size_t vertex_count = 0;
    std::size_t index_count = 0;
    for (const scene::Mesh& mesh : scene.meshes) {
        ranges.push_back({static_cast<GLint>(vertex_count), index_count,
                          static_cast<GLsizei>(mesh.indices.size()), mesh.relief});
        vertex_count += mesh.positions_m.size();
        index_count += mesh.indices.size();
    }
    std::vector<Vertex> vertices(std::max<std::size_t>(vertex_count, 1));
    std::vector<std::uint32_t> indices(std::max<std::size_t>(index_count, 1));
    pool.parallel_for(scene.meshes.size(), [&](std::size_t m) {
        const scene::Mesh& mesh = scene.meshes[m];
        for (std::size_t i = 0; i < mesh.positions_m.size(); ++i)
            vertices[static_cast<std::size_t>(ranges[m].base_vertex) + i] = vertex_of(mesh, i);
        std::copy(mesh.indices.begin(), mesh.indices.end(),
                  indices.begin() + static_cast<std::ptrdiff_t>(ranges[m].first_index));
    });
    out.vertices = gl::make_buffer(gl, std::as_bytes(std::span(vertices)));
    out.indices = gl::make_buffer(gl, std::as_bytes(std::span(indices)));
    out.vertex_array = gl::make_vertex_array(gl);
    describe_vertices(gl, out);
}

}  // namespace facet::frame
