// Shadows on the ground below a scene, for a rasteriser's picture.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "trace/path.h"
#include "trace/seen.h"

#include <optional>

namespace facet::trace {

/// Where a ray meets scene::Ground from above; none where it does not.
[[nodiscard]] std::optional<math::Vec3> meet_ground(const World& world, const Ray& ray);

/// `world` has a ground. Of `seen` the rays count alone: ground behind a surface is lit too, so
/// that the samples of an edge find it. The same bytes for any number of threads.
[[nodiscard]] GroundPixels light_ground(const World& world, const Seen& seen,
                                        const GatherSettings& settings, base::ThreadPool& pool);

}  // namespace facet::trace
