// The reference picture of a session.
// SPDX-License-Identifier: MIT
#include "render/reference.h"

#include "render/session.h"
#include "trace/trace.h"

namespace facet::render {
namespace {

void warn(const trace::Traced& traced, base::Warnings& warnings) {
    if (traced.not_finite > 0)
        warnings.push_back({.where = "reference",
                            .what = "samples that are not finite were left out",
                            .found = fmt::format("{} of {}", traced.not_finite, traced.paths)});
    if (traced.stopped_by_time)
        warnings.push_back({.where = "reference",
                            .what = "the time limit ended it early",
                            .found = fmt::format("{:.1f} samples per pixel", traced.samples),
                            .remedy = "a larger --time-limit"});
}

}  // namespace

base::Result<Reference> trace_reference(const Session& session, const Request& request,
                                        const Plan& plan, double exposure, base::ThreadPool& pool,
                                        const base::Progress& progress, Rendered& out) {
    const Job& job = session.job();
    auto tracer = trace::Tracer::create(
        {.scene = job.scene,
         .environment = job.environment,
         .camera = job.camera,
         .env_rotation_deg = request.settings.env_rotation,
         .env_intensity = request.settings.env_intensity,
         .shows_environment = plan.background.kind == frame::BackgroundKind::environment,
         .brdf = plan.brdf},
        plan.limits, pool);
    if (!tracer) return tl::unexpected(tracer.error());
    const trace::TraceSettings settings{.picture = plan.picture,
                                        .x = plan.region.x,
                                        .y = plan.region.y,
                                        .size = plan.region.size,
                                        .samples = plan.reference->samples,
                                        .noise = plan.reference->noise,
                                        .exposure = exposure,
                                        .time_s = plan.reference->time_s,
                                        .seed = request.settings.seed};
    trace::Traced traced = tracer->trace(settings, pool, progress);
    Reference reference{.radiance = std::move(traced.radiance),
                        .aovs = tracer->aovs(settings, plan.aovs, pool)};
    warn(traced, out.warnings);
    out.reference = ReferenceReport{.samples = traced.samples,
                                    .noise = traced.noise,
                                    .paths = traced.paths,
                                    .rays = traced.rays,
                                    .stopped_by_time = traced.stopped_by_time,
                                    .build_s = traced.build_s,
                                    .trace_s = traced.trace_s};
    return reference;
}

}  // namespace facet::render
