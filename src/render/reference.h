// The reference picture of a session: traced, then shown as the rasteriser's is.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "base/thread_pool.h"
#include "render/plan.h"
#include "render/render.h"

namespace facet::render {

class Session;

struct Reference {
    image::Image radiance;  ///< nit, associated coverage, f32 [height, width, 4]
    std::vector<image::Layer> aovs;
};

/// --compare: raster, reference and their difference side by side. Both u8 or u16 RGBA; fills
/// `out.compared`.
[[nodiscard]] base::Result<image::Image> compare_displayed(const image::Image& raster,
                                                           const image::Image& reference,
                                                           const Plan& plan, Rendered& out);

/// Traces what the session has loaded, and fills report and warnings of `out`. `exposure` is what
/// --reference auto:NOISE measures display values by.
[[nodiscard]] base::Result<Reference> trace_reference(const Session& session,
                                                      const Request& request, const Plan& plan,
                                                      double exposure, base::ThreadPool& pool,
                                                      const base::Progress& progress,
                                                      Rendered& out);

}  // namespace facet::render
