// The path-traced reference in the background.
// SPDX-License-Identifier: MIT
#include "studio/reference_worker.h"

#include "base/thread_pool.h"
#include "render/job.h"
#include "render/plan.h"
#include "trace/trace.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace facet::studio {
namespace {

/// Of Linux's 19: behind everything that somebody waits for.
constexpr int nice_level = 15;

/// One core is the studio's.
unsigned worker_threads() { return std::max(1U, std::thread::hardware_concurrency() - 1U); }

}  // namespace

struct ReferenceWorker::Work {
    render::Job job;
    render::Plan plan;
    tables::Settings settings;
    std::uint32_t samples = 0;
};

void ReferenceWorker::start(const render::Job& job, const render::Plan& plan,
                            const tables::Settings& settings, std::uint32_t samples) {
    stop();
    cancelled_ = false;
    running_ = true;
    auto work = std::make_shared<const Work>(Work{job, plan, settings, samples});
    thread_ = std::thread([this, work] { run(work); });
}

void ReferenceWorker::stop() {
    cancelled_ = true;
    if (thread_.joinable()) thread_.join();
    const std::lock_guard lock(mutex_);
    newest_.reset();
    trouble_.clear();
}

std::optional<ReferencePicture> ReferenceWorker::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(newest_, std::nullopt);
}

std::string ReferenceWorker::trouble() const {
    const std::lock_guard lock(mutex_);
    return trouble_;
}

void ReferenceWorker::give(ReferencePicture picture) {
    {
        const std::lock_guard lock(mutex_);
        newest_ = std::move(picture);
    }
    wake_();
}

void ReferenceWorker::run(const std::shared_ptr<const Work>& work) {
    // On Linux a thread has a niceness of its own, and those it starts inherit it.
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), nice_level);
    base::ThreadPool pool(worker_threads());
    const render::Plan& plan = work->plan;
    const auto tracer = trace::Tracer::create(
        {.scene = work->job.scene,
         .environment = work->job.environment,
         .camera = work->job.camera,
         .env_rotation_deg = work->settings.env_rotation,
         .env_intensity = work->settings.env_intensity,
         .shows_environment = plan.background.kind == frame::BackgroundKind::environment,
         .background_blur = plan.background.blur,
         .brdf = plan.brdf},
        plan.limits, pool);
    if (!tracer) {
        const std::lock_guard lock(mutex_);
        trouble_ = base::to_line(tracer.error());
        running_ = false;
        return;
    }
    const trace::TraceSettings settings{.picture = plan.picture,
                                        .size = plan.picture,
                                        .samples = work->samples,
                                        .seed = work->settings.seed,
                                        .largest_pass = 4,
                                        .cancelled = &cancelled_};
    trace::Traced traced =
        tracer->trace(settings, pool, {}, [&](const image::Image& radiance, double samples) {
            give({radiance, samples, false});
        });
    running_ = false;
    if (!cancelled_) give({std::move(traced.radiance), traced.samples, true});
}

}  // namespace facet::studio
