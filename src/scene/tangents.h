// Tangents for normal maps, in the space that MikkTSpace defines and glTF asks for.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <optional>

namespace facet::scene {

/// Fills mesh.tangents from its normals and texture coordinates `uv_set` (0 or 1), in the way of
/// Mikkelsen's MikkTSpace, which normal maps are baked for: corners are grouped by position, normal
/// and coordinate, by connection over edges and by handedness; each group's tangent is the
/// angle-weighted mean of its faces'. Vertices whose corners fall into several groups are split, so
/// every vertex array may grow and the indices change; triangles keep their order. w is the
/// handedness: bitangent = w cross(n, t), towards the top of the image (glTF's v points down).
/// Corners without a usable coordinate get any tangent square to the normal. Precondition: normals
/// and the uv set are as long as positions. Source: Mikkelsen 2008, "Simulation of Wrinkled
/// Surfaces Revisited", section 3.3 and its published algorithm.
void generate_tangents(Mesh& mesh, std::uint32_t uv_set);

/// The texture whose coordinates a material's tangents follow: its first normal map, else what
/// turns its anisotropy; an empty one where it has neither, but is anisotropic. None: it needs no
/// tangents.
[[nodiscard]] std::optional<Texture> tangents_texture(const Material& material);
/// Gives a mesh without tangents those that its material needs: by its coordinates, or, for
/// anisotropy where it has none, around the y axis of the mesh.
void fill_tangents(Mesh& mesh, const Material& material);
/// The same for every mesh.
void generate_missing_tangents(Scene& scene);

}  // namespace facet::scene
