// A mesh at one pose: morphed, skinned, and completed with what it lacks.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/rig.h"

#include <cstddef>
#include <span>

namespace facet::scene {

/// What differs between two uses of one shape.
struct Deformation {
    std::span<const float> weights;  ///< of morph targets; those without count as 0
    std::span<const Mat4> joints;    ///< world_from_object of each joint; empty: no skin
    bool is_mirrored = false;        ///< will be placed by a matrix of negative determinant
};

struct Deformed {
    Mesh mesh;                       ///< without indices and vertices where no triangle has an area
    std::size_t flat_triangles = 0;  ///< without an area, left out
    std::size_t mended_normals = 0;  ///< that were zero, taken from the faces around
};

/// `mesh` is the shape's own, or a copy. `material` tells whether tangents are wanted, and of which
/// coordinates. Precondition: joints of positive weight are there.
[[nodiscard]] Deformed deformed(Mesh mesh, const Shape& shape, const Deformation& by,
                                const Material& material);

/// Normal of the triangle whose indices begin at `first`, as long as twice its area.
[[nodiscard]] Vec3 scaled_face_normal(const Mesh& mesh, std::size_t first);

/// Turns the triangles and the handedness round.
void mirror(Mesh& mesh);

}  // namespace facet::scene
