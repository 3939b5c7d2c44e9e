// A session's picture, drawn to the end.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "base/thread_pool.h"
#include "render/plan.h"
#include "render/render.h"

namespace facet::render {

class Session;

/// What a picture is made with, apart from what it shows.
struct DrawTools {
    base::ThreadPool& pool;
    const base::Progress& progress;
};

/// Draws all samples of what the session holds, by raster or by reference, and fills display or
/// layers, exposure, reports and warnings of `out`. `plan` is the session's.
[[nodiscard]] base::Status draw(Session& session, const Request& request, const Plan& plan,
                                const DrawTools& tools, Rendered& out);

}  // namespace facet::render
