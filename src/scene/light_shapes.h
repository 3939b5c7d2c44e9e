// The shapes of lights that are seen themselves, as meshes of the scene.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"

#include <cstddef>

namespace facet::scene {

/// How much of a scene is the model's own: what place_light_shapes() added follows.
struct ModelCounts {
    std::size_t materials = 0;
    std::size_t meshes = 0;
    std::size_t instances = 0;
};
[[nodiscard]] ModelCounts model_counts(const Scene& scene);

/// Leaves the model alone.
void remove_light_shapes(Scene& scene);
/// Gives each light that is visible its shape, in place of those that were there: triangles that
/// show its radiance, and black ones where it does not shine, at the backs of panels and the ends
/// of tubes. They lie within the light's true surface, so that none is in the way of its own light.
void place_light_shapes(Scene& scene);

}  // namespace facet::scene
