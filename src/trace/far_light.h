// Light through the surfaces of a picture.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "trace/path.h"
#include "trace/seen.h"

namespace facet::trace {

/// SampleLight::far: by `settings.far` paths a pixel, smoothed over each surface that is too rough,
/// or sends on too diffuse a light, to show a picture.
[[nodiscard]] std::vector<math::Vec4> far_light(const World& world, const Seen& seen,
                                                const GatherSettings& settings, std::uint32_t frame,
                                                base::ThreadPool& pool);

}  // namespace facet::trace
