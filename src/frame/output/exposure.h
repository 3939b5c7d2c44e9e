// Automatic exposure.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"

#include <span>

namespace facet::frame {

/// 0.18 over the log-average luminance of the covered pixels (contract; Reinhard et al. 2002, Eq. 1
/// and 2, with the key 0.18). `radiance` is RGBA [n, 4] in nit times `frame_count`; `depth` [n] in
/// window space: covered is below 1, and everything where nothing is. Pixels below 1e-4 of the mean
/// are left out: where no light falls there is nothing to expose for, and their logarithms have no
/// end. 1 where there is no light at all. Same for any thread count.
[[nodiscard]] double auto_exposure(std::span<const float> radiance, std::span<const float> depth,
                                   std::uint32_t frame_count, base::ThreadPool& pool);

}  // namespace facet::frame
