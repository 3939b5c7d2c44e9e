// Which lights reach the surfaces of a picture.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "trace/path.h"
#include "trace/seen.h"

namespace facet::trace {

/// `sample`: where in a wide light is looked at. Share of each light that reaches each pixel,
/// 0..255: [slot, height, width, RGBA] by place in the pixel's choice; A is unused. Slots beyond
/// `slots` are left out.
/// The same bytes for any number of threads.
[[nodiscard]] std::vector<std::uint8_t> light_visibility(const World& world, const Seen& seen,
                                                         const LightChoice& lights,
                                                         std::size_t slots, const SampleId& sample,
                                                         base::ThreadPool& pool);

}  // namespace facet::trace
