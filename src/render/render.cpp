// One request, one picture.
// SPDX-License-Identifier: MIT
#include "render/render.h"

#include "base/thread_pool.h"
#include "render/draw.h"
#include "render/plan.h"
#include "render/session.h"
#include "render/stopwatch.h"

namespace facet::render {

base::Result<Rendered> render(const Request& request, base::Log& log,
                              const base::Progress& progress) {
    const auto plan = make_plan(request.settings);
    if (!plan) return tl::unexpected(plan.error());
    base::ThreadPool pool(request.settings.threads);
    Rendered out;
    auto opened = open(request, *plan, pool, log, out);
    if (!opened) return tl::unexpected(opened.error());
    Stopwatch watch;
    auto session = Session::create(opened->gl, std::move(opened->job), request.settings, *plan,
                                   pool, out.warnings);
    if (!session) return tl::unexpected(session.error());
    out.ms.upload = watch.lap_ms();
    if (auto drawn = draw(*session, request, *plan, {pool, progress}, out); !drawn)
        return tl::unexpected(drawn.error());
    out.ms.render = watch.lap_ms();
    log.debug("load {:.0f} ms, upload {:.0f} ms, render {:.0f} ms", out.ms.load, out.ms.upload,
              out.ms.render);
    return out;
}

}  // namespace facet::render
