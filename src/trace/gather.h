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

}  // namespace facet::trace
