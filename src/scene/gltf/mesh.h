// A glTF primitive on its way to a Mesh: read, morphed, skinned, triangulated, completed.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/import.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace facet::scene::gltf {

/// The vertex streams of one primitive. Mesh arrays are empty or as long as positions_m.
struct Streams {
    Mesh mesh;
    std::size_t influence_count = 0;    ///< joints a vertex: 0, 4 or 8
    std::vector<std::uint32_t> joints;  ///< [vertices, influence_count]
    std::vector<float> joint_weights;   ///< same shape; each row sums to 1, or is 0
};

/// What differs between two uses of one primitive.
struct Pose {
    std::vector<double> morph_weights;
    std::span<const Mat4> joints;  ///< world_from_bind of each joint; empty: no skin
    bool is_mirrored = false;      ///< will be placed by a matrix of negative determinant
};

/// Attributes of `primitive`, decoded. Errors: those of the elements (NaN positions, counts that
/// differ).
[[nodiscard]] base::Result<Streams> read_streams(Import& import,
                                                 const tinygltf::Primitive& primitive,
                                                 const std::string& where);
/// Adds the weighted morph targets.
[[nodiscard]] base::Status apply_morphs(Import& import, const tinygltf::Primitive& primitive,
                                        std::span<const double> weights, const std::string& where,
                                        Mesh& mesh);
/// Moves vertices to where their joints are. Errors: a joint index without a joint.
[[nodiscard]] base::Status apply_skin(std::span<const Mat4> joints, const std::string& where,
                                      Streams& streams);

/// Triangles of the primitive's indices and mode, counter-clockwise front. Errors: an index out of
/// range.
[[nodiscard]] base::Result<std::vector<std::uint32_t>> read_triangles(
    Import& import, const tinygltf::Primitive& primitive, std::size_t vertex_count,
    const std::string& where);
/// Drops triangles without area; how many there were.
std::size_t drop_degenerates(Mesh& mesh);
/// Gives every triangle three vertices of its own and its face normal.
void make_flat(Mesh& mesh);
/// Scales normals to 1; where one is zero or not finite, takes the mean of the faces around. How
/// many those were.
std::size_t mend_normals(Mesh& mesh);
/// Turns the triangles and the handedness round.
void mirror(Mesh& mesh);

/// The whole way. Nothing, with a warning, where the primitive draws no surface.
[[nodiscard]] base::Result<std::optional<Mesh>> build_mesh(Import& import, std::size_t mesh_index,
                                                           std::size_t primitive_index,
                                                           const Pose& pose);

}  // namespace facet::scene::gltf
