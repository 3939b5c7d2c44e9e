// The reference picture of a session.
// SPDX-License-Identifier: MIT
#include "render/reference.h"

#include "image/compare.h"
#include "image/panels.h"
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

image::Picture picture_of(const image::Image& display) {
    return {.layers = {{.name = "", .channels = {"R", "G", "B", "A"}, .image = display}},
            .metadata = {},
            .format = tables::ImageFormat::png};
}

/// Layers in the order of `aovs`, from those that are light paths and those that are not.
std::vector<image::Layer> in_order(const std::vector<tables::Aov>& aovs,
                                   std::vector<image::Layer> paths,
                                   std::vector<image::Layer> others) {
    std::vector<image::Layer> out;
    std::size_t path = 0;
    std::size_t other = 0;
    for (const tables::Aov aov : aovs)
        out.push_back(std::move(tables::row(aov).kind == tables::AovKind::light_path
                                    ? paths[path++]
                                    : others[other++]));
    return out;
}

}  // namespace

base::Result<image::Image> compare_displayed(const image::Image& raster,
                                             const image::Image& reference, const Plan& plan,
                                             Rendered& out) {
    const image::Picture a = picture_of(raster);
    const image::Picture b = picture_of(reference);
    const auto covered = image::compare(a, b, {.pixels = image::Pixels::covered});
    const auto whole = image::compare(b, a, {.heat = image::Heat::flip});
    if (!whole) return tl::unexpected(whole.error());
    // Where nothing is covered there is nothing but background, and that is compared.
    const image::Difference& d = covered ? *covered : *whole;
    out.compared =
        Compared{d.rmse, d.psnr_db, d.max_error, whole->flip.value_or(0.0), d.pixel_count};
    const image::Panel panels[] = {
        {&raster, {"raster", fmt::format("{} samples", plan.sample_count)}},
        {&reference,
         {"reference", fmt::format("{:.4g} samples, noise {:.2g}", out.reference->samples,
                                   out.reference->noise)}},
        {&whole->heat,
         {"difference", fmt::format("rmse {:.4f}  flip {:.4f}", d.rmse, out.compared->flip)}}};
    return image::side_by_side(panels);
}

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
         .background_blur = plan.background.blur,
         .brdf = plan.brdf,
         .key_light = key_light(job, plan.aovs)},
        plan.limits, pool);
    if (!tracer) return tl::unexpected(tracer.error());
    const trace::TraceSettings settings{
        .picture = plan.picture,
        .x = plan.region.x,
        .y = plan.region.y,
        .size = plan.region.size,
        .samples = plan.reference->samples,
        .noise = plan.reference->noise,
        .exposure = exposure,
        .time_s = plan.reference->time_s,
        .seed = request.settings.seed,
        .light_paths = tables::of_kind(plan.aovs, tables::AovKind::light_path)};
    trace::Traced traced = tracer->trace(settings, pool, progress);
    Reference reference{.radiance = std::move(traced.radiance),
                        .aovs = in_order(plan.aovs, std::move(traced.light_paths),
                                         tracer->aovs(settings, plan.aovs, pool))};
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
