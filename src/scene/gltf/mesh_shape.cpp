// Triangles out of a primitive's mode and indices.
// SPDX-License-Identifier: MIT
#include "scene/gltf/elements.h"
#include "scene/gltf/mesh.h"

#include <spdlog/fmt/fmt.h>

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

}  // namespace

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

}  // namespace facet::scene::gltf
