// Indirect light at the surfaces of a picture, by a few paths each.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "trace/path.h"
#include "trace/seen.h"

namespace facet::trace {

/// The same bytes for any number of threads.
[[nodiscard]] IndirectPixels gather(const World& world, const Seen& seen,
                                    const GatherSettings& settings, base::ThreadPool& pool);

/// Light at the samples of one frame where the middles of pixels do not tell of it: what surfaces
/// smoother than `settings.mirrored_alpha` mirror, and all where `middles` are intricate.
[[nodiscard]] SampleLight sample_light(const World& world, const Seen& seen,
                                       const IndirectPixels& middles,
                                       const GatherSettings& settings, std::uint32_t frame,
                                       base::ThreadPool& pool);

}  // namespace facet::trace
