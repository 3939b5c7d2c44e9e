// A picture as a view of OpenColorIO shows it.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "image/image.h"

namespace facet::render {

struct Plan;

/// `radiance` is f32 [height, width, 4] in nit, associated coverage. As Rendered::display. Errors:
/// usage (no such view, with those there are), feature_missing (without the module).
[[nodiscard]] base::Result<image::Image> ocio_picture(image::Image radiance, double exposure,
                                                      const Plan& plan);

}  // namespace facet::render
