// The benchmark: how long a frame takes.
// SPDX-License-Identifier: MIT
#include "render/bench.h"

#include "base/thread_pool.h"
#include "render/job.h"
#include "render/session.h"
#include "render/stopwatch.h"
#include "trace/trace.h"

#include <sys/resource.h>

#include <algorithm>
#include <random>

namespace facet::render {
namespace {

using math::Vec3;

constexpr std::uint32_t warm_up_frames = 3;
constexpr std::size_t surface_points = 2000;
constexpr double wanted_reach = 4.0;

/// Points of the surface, spread over all instances.
std::vector<Vec3> surface(const scene::Scene& scene) {
    std::vector<Vec3> points;
    std::size_t total = 0;
    for (const auto& instance : scene.instances)
        total += scene.meshes[instance.mesh.index].positions_m.size();
    const std::size_t step = std::max<std::size_t>(1, total / surface_points);
    std::size_t i = 0;
    for (const auto& instance : scene.instances)
        for (const Vec3& p : scene.meshes[instance.mesh.index].positions_m)
            if (i++ % step == 0)
                points.emplace_back(instance.world_from_object * math::Vec4(p, 1.0F));
    return points;
}

double reach(const std::vector<Vec3>& points, const std::vector<Vec3>& lights, float range) {
    std::size_t hits = 0;
    for (const Vec3& p : points)
        for (const Vec3& l : lights) hits += math::dot(p - l, p - l) < range * range ? 1U : 0U;
    return points.empty() ? 0.0 : static_cast<double>(hits) / static_cast<double>(points.size());
}

/// Lights over the surface, each a tenth of the model away from it; the range is found by
/// bisection.
std::vector<scene::Light> local_lights(const scene::Scene& scene, const BenchRequest& request,
                                       double& found) {
    const std::vector<Vec3> points = surface(scene);
    const float size = std::max(scene.bounds_m().diagonal(), 1e-6F);
    std::mt19937 random(
        1);  // its sequence is the standard's; distributions are not, so they are not used
    const auto unit = [&] { return static_cast<float>(random()) / 4294967296.0F; };
    std::vector<Vec3> places;
    for (std::uint32_t i = 0; i < request.lights && !points.empty(); ++i) {
        const Vec3 out = Vec3(unit(), unit(), unit()) - 0.5F;
        places.push_back(points[random() % points.size()] + out * (0.2F * size));
    }
    float low = 0.0F;
    float high = 2.0F * size;
    for (int step = 0; step < 30; ++step) {
        const float middle = 0.5F * (low + high);
        (reach(points, places, middle) < wanted_reach ? low : high) = middle;
    }
    found = reach(points, places, high);
    std::vector<scene::Light> lights;
    for (std::size_t i = 0; i < places.size(); ++i) {
        scene::Light light{.kind = request.kinds[i % request.kinds.size()],
                           .color = Vec3(0.4F) + 0.6F * Vec3(unit(), unit(), unit()),
                           .intensity = high * high,
                           .position_m = places[i],
                           .direction = Vec3(0.0F, -1.0F, 0.0F),
                           .range_m = high,
                           .radius_m = 0.05F * high,
                           .width_m = 0.2F * high,
                           .height_m = 0.1F * high};
        if (const float area = scene::area_m2(light); area > 0.0F) light.intensity /= area;
        lights.push_back(light);
    }
    return lights;
}

double percentile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const double at = share * static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(at + 0.5)];
}

double peak_rss_mb() {
    struct rusage usage {};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

struct Samples {
    std::vector<double> frame, gbuffer, lighting, post;
};

base::Status draw_frame(Session& session, double exposure, bool passes, Samples* out) {
    Stopwatch watch;
    frame::PassTimes times;
    if (auto drawn = session.draw(0, 1, passes ? &times : nullptr); !drawn) return drawn;
    if (auto shown = session.display(exposure, 1); !shown) return shown;
    session.finish();
    const double ms = watch.lap_ms();
    if (out == nullptr) return {};
    out->frame.push_back(ms);
    out->gbuffer.push_back(times.gbuffer);
    out->lighting.push_back(times.lighting);
    out->post.push_back(passes ? ms - times.gbuffer - times.lighting : 0.0);
    return {};
}

}  // namespace

base::Result<BenchResult> bench(const BenchRequest& request, base::Log& log) {
    const auto plan = make_plan(request.settings);
    if (!plan) return tl::unexpected(plan.error());
    base::ThreadPool pool(request.settings.threads);
    Rendered loaded;
    auto opened = open({request.scene, request.settings}, *plan, pool, log, loaded);
    if (!opened) return tl::unexpected(opened.error());
    auto session = Session::create(opened->gl, std::move(opened->job), request.settings, *plan,
                                   pool, loaded.warnings);
    if (!session) return tl::unexpected(session.error());
    BenchResult result{
        .size = loaded.size, .backend = loaded.backend, .threads = pool.thread_count()};
    auto lights = local_lights(session->scene(), request, result.reach);
    lights.push_back({.kind = tables::LightKind::directional,
                      .intensity = 3.0F,
                      .direction = -math::direction_from(60.0F, 40.0F)});
    session->set_lights(lights);
    Stopwatch watch;
    if (auto drawn = draw_frame(*session, 1.0, false, nullptr); !drawn)
        return tl::unexpected(drawn.error());
    result.first_frame_ms = watch.lap_ms();
    const double exposure = plan->exposure ? *plan->exposure : session->measure_exposure(1);
    Samples samples;
    for (std::uint32_t i = 0; i < warm_up_frames + std::max(1U, request.frames); ++i)
        if (auto drawn = draw_frame(*session, exposure, request.passes,
                                    i < warm_up_frames ? nullptr : &samples);
            !drawn)
            return tl::unexpected(drawn.error());
    result.median_ms = percentile(samples.frame, 0.5);
    result.p5_ms = percentile(samples.frame, 0.05);
    result.p95_ms = percentile(samples.frame, 0.95);
    result.gbuffer_ms = percentile(samples.gbuffer, 0.5);
    result.lighting_ms = percentile(samples.lighting, 0.5);
    result.post_ms = percentile(samples.post, 0.5);
    result.peak_rss_mb = peak_rss_mb();
    return result;
}

base::Result<ReferenceBenchResult> bench_reference(const BenchRequest& request) {
    const auto plan = make_plan(request.settings);
    if (!plan) return tl::unexpected(plan.error());
    base::ThreadPool pool(request.settings.threads);
    auto job = load_job({request.scene, request.settings}, *plan, pool);
    if (!job) return tl::unexpected(job.error());
    double reached = 0.0;
    for (scene::Light& light : local_lights(job->scene, request, reached))
        job->scene.lights.push_back(std::move(light));
    const auto tracer = trace::Tracer::create({.scene = job->scene,
                                               .environment = job->environment,
                                               .camera = job->camera,
                                               .shows_environment = false,
                                               .brdf = plan->brdf},
                                              plan->limits, pool);
    if (!tracer) return tl::unexpected(tracer.error());
    ReferenceBenchResult result{
        .size = plan->picture, .threads = pool.thread_count(), .samples = plan->reference->samples};
    std::vector<double> seconds;
    trace::Traced traced;
    for (std::uint32_t i = 0; i < std::max(1U, request.frames); ++i) {
        traced = tracer->trace(
            {.picture = plan->picture, .size = plan->picture, .samples = plan->reference->samples},
            pool);
        seconds.push_back(traced.trace_s);
    }
    result.median_s = percentile(seconds, 0.5);
    result.build_s = traced.build_s;
    result.paths_per_s = static_cast<double>(traced.paths) / result.median_s;
    result.rays_per_path = static_cast<double>(traced.rays) / static_cast<double>(traced.paths);
    const auto values = traced.radiance.as<float>();
    for (std::size_t i = 3; i < values.size(); i += 4)
        result.covered += static_cast<double>(values[i]);
    result.covered /= static_cast<double>(plan->picture.pixels());
    result.peak_rss_mb = peak_rss_mb();
    return result;
}

}  // namespace facet::render
