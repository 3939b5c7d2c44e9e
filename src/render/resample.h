// Pictures that no flat view is: panoramas, and those of lenses that bend; drawn as flat views and
// resampled. SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "image/image.h"
#include "scene/scene.h"

namespace facet::base {
class ThreadPool;
}

namespace facet::render {

class Session;

struct Resampled {
    image::Image radiance;  ///< f32 [height, width, 4], nit, associated coverage
    double exposure = 1.0;  ///< automatic, of the flat views
};
/// The session draws views of its own meanwhile, and is as it was afterwards. Errors: as
/// Session::draw().
[[nodiscard]] base::Result<Resampled> draw_resampled(Session& session, base::ThreadPool& pool);

struct Around {
    image::Image radiance;  ///< f32 [size.height, size.width, 4], nit, the middle straight ahead
    double covered = 0.0;   ///< share of it that surfaces fill, about
};
/// All that is seen around a camera.
[[nodiscard]] base::Result<Around> draw_around(Session& session, const scene::Camera& camera,
                                               math::Extent size, std::uint32_t samples,
                                               base::ThreadPool& pool);

}  // namespace facet::render
