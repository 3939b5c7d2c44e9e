// A glTF primitive on its way to a Mesh: read, triangulated, posed.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/deform.h"
#include "scene/gltf/import.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace facet::scene::gltf {

/// Attributes of `primitive`, decoded. Errors: those of the elements (NaN positions, counts that
/// differ).
[[nodiscard]] base::Result<Shape> read_streams(Import& import, const tinygltf::Primitive& primitive,
                                               const std::string& where);
/// The morph targets, of a file without clips those alone that have a weight.
[[nodiscard]] base::Status read_targets(Import& import, const tinygltf::Primitive& primitive,
                                        std::span<const float> weights, const std::string& where,
                                        Shape& shape);
/// Errors: a joint index without a joint.
[[nodiscard]] base::Status check_joints(const Shape& shape, std::size_t joint_count,
                                        const std::string& where);

/// The primitive's indices, or 0, 1, … where it has none. Errors: input_invalid (an index out of
/// range).
[[nodiscard]] base::Result<std::vector<std::uint32_t>> read_indices(
    const Import& import, const tinygltf::Primitive& primitive, std::size_t vertex_count,
    const std::string& where);
/// Triangles of the primitive's indices and mode, counter-clockwise front. Errors: an index out of
/// range.
[[nodiscard]] base::Result<std::vector<std::uint32_t>> read_triangles(
    Import& import, const tinygltf::Primitive& primitive, std::size_t vertex_count,
    const std::string& where);
/// Position, normal, tangent, two coordinates, color, joints.
inline constexpr std::size_t vertex_bytes = 80;

/// Which primitive of which mesh.
struct PrimitiveId {
    std::size_t mesh = 0;
    std::size_t primitive = 0;
};
/// All of it but its pose; `weights` are what the morph targets count. Nothing, with a warning,
/// where it draws no surface.
[[nodiscard]] base::Result<std::optional<Shape>> read_shape(Import& import, const PrimitiveId& id,
                                                            std::span<const float> weights);
/// The shape in a pose, with warnings of what is left out of it. Errors: a joint index without a
/// joint.
[[nodiscard]] base::Result<Mesh> build_mesh(Import& import, const PrimitiveId& id, Shape shape,
                                            const Deformation& by);

}  // namespace facet::scene::gltf
