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

/// What smooth surfaces mirror, for one frame: [height, width]; rgb: nit, as
/// IndirectPixels::specular; a: 1 where the surface's alpha is below `alpha`, else 0. `frame`:
/// which sample of the sequence.
[[nodiscard]] std::vector<math::Vec4> mirrored(const World& world, const Seen& seen, float alpha,
                                               std::uint32_t frame, std::uint32_t seed,
                                               base::ThreadPool& pool);

}  // namespace facet::trace
