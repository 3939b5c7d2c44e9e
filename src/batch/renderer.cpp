// Renders one item after another, and keeps what they share.
// SPDX-License-Identifier: MIT
#include "batch/renderer.h"

#include "base/text.h"
#include "render/draw.h"
#include "render/session.h"
#include "render/stopwatch.h"

#include <cmath>

namespace facet::batch {
namespace {

/// Two pictures of one key differ in settings alone.
std::string scene_key(const std::string& scene, const tables::Settings& settings) {
    return scene + "\n" + settings.variant + "\n" + base::join(settings.ignore_required, ",") +
           (settings.strict ? "\nstrict" : "");
}

Shot shot_of(const scene::Camera& camera, const render::Plan& plan) {
    Shot shot{.size = plan.picture, .world_from_camera = camera.world_from_view};
    const double height = plan.picture.height;
    if (camera.projection == scene::Projection::orthographic)
        shot.ortho_height_m = 2.0 * static_cast<double>(camera.ymag_m);
    else
        shot.focal_y_px = 0.5 * height / std::tan(0.5 * static_cast<double>(camera.yfov_rad));
    shot.focal_x_px = shot.focal_y_px;
    return shot;
}

}  // namespace

Renderer::Renderer(const Inputs& in) : in_(in), assets_(in.asset_bytes) {}
Renderer::~Renderer() = default;

void Renderer::prepare(const Item& item) {
    if (loading_ && loading_->scene == item.scene) return;
    loading_.reset();  // waits
    const auto plan = render::make_plan(item.settings);
    if (!plan) return;
    loading_ = Loading{
        item.scene, std::async(std::launch::async, [this, settings = item.settings,
                                                    scene = item.scene, limits = plan->limits] {
            // On threads of its own: the pool works for the picture.
            base::ThreadPool own(in_.pool.thread_count());
            static_cast<void>(assets_.scene(scene, render::load_options(settings), limits, own));
            static_cast<void>(assets_.environment(settings.env, limits, own));
        })};
}

base::Status Renderer::show(const render::Request& request, const render::Plan& plan,
                            render::Rendered& out) {
    render::Stopwatch watch;
    if (loading_ && loading_->scene == request.scene) loading_.reset();  // waits
    const std::string key = scene_key(request.scene, request.settings);
    base::Warnings baking;
    if (key == shown_) {
        const auto shared = assets_.scene(request.scene, render::load_options(request.settings),
                                          plan.limits, in_.pool);
        if (!shared) return tl::unexpected(shared.error());
        const auto environment = assets_.environment(request.settings.env, plan.limits, in_.pool);
        if (!environment) return tl::unexpected(base::in_file(environment.error(), "--env"));
        out.warnings = (*shared)->warnings;
        out.warnings.insert(out.warnings.end(), (*environment)->warnings.begin(),
                            (*environment)->warnings.end());
        out.reads = (*shared)->reads;
        out.ms.load = watch.lap_ms();
        if (auto s = session_->update(request.settings, plan, baking); !s) return s;
    } else {
        auto job = render::load_job(request, plan, in_.pool, &assets_);
        if (!job) return tl::unexpected(job.error());
        out.ms.load = watch.lap_ms();
        out.warnings = job->warnings;
        out.reads = job->reads;
        shown_.clear();
        if (session_ != nullptr) {
            if (auto s = session_->enter(std::move(*job), request.settings, plan, baking); !s)
                return s;
        } else {
            auto session = render::Session::create(*gl_, std::move(*job), request.settings, plan,
                                                   in_.pool, baking);
            if (!session) return tl::unexpected(session.error());
            session_ = std::make_unique<render::Session>(std::move(*session));
            session_->use(assets_);
        }
        shown_ = key;
    }
    out.ms.upload = watch.lap_ms();
    out.warnings.insert(out.warnings.end(), baking.begin(), baking.end());
    return {};
}

base::Result<double> Renderer::exposure_of(std::size_t first) {
    if (const auto known = exposures_.find(first); known != exposures_.end()) return known->second;
    const auto item = in_.job.item(first);
    if (!item) return tl::unexpected(item.error());
    const auto plan = render::make_plan(item->settings);
    if (!plan) return tl::unexpected(plan.error());
    render::Rendered measured;
    const render::Request request{
        .scene = item->scene, .settings = item->settings, .cache_folder = in_.cache_folder};
    if (auto s = show(request, *plan, measured); !s) return tl::unexpected(s.error());
    session_->begin_picture();
    for (std::uint32_t i = 0; i < plan->sample_count; ++i)
        if (auto drawn = session_->draw(i, plan->sample_count); !drawn)
            return tl::unexpected(drawn.error());
    return exposures_[first] = session_->measure_exposure(plan->sample_count);
}

base::Result<Drawn> Renderer::draw(const Item& item) {
    Drawn out;
    out.request = {
        .scene = item.scene, .settings = item.settings, .cache_folder = in_.cache_folder};
    auto file = render::plan_file(item.settings, item.output);
    if (!file) return tl::unexpected(file.error());
    out.file = std::move(*file);
    out.request.want_linear = out.file.holds_radiance();
    auto plan = render::make_plan(item.settings);
    if (!plan) return tl::unexpected(plan.error());
    if (gl_ && backend_ != plan->backend) {
        session_.reset();
        shown_.clear();
        gl_.reset();
    }
    if (!gl_) {
        backend_ = plan->backend;
        auto gl = gl::Context::create(plan->backend, in_.log);
        if (!gl) return tl::unexpected(gl.error());
        gl_ = std::move(*gl);
    }
    if (item.frame && !plan->exposure) {
        const auto exposure = exposure_of(item.index - *item.frame);
        if (!exposure) return tl::unexpected(exposure.error());
        plan->exposure = *exposure;
    }
    render::Rendered& rendered = out.rendered;
    rendered.size = plan->region.size;
    if (auto s = show(out.request, *plan, rendered); !s) return tl::unexpected(s.error());
    render::Stopwatch watch;
    const base::Progress no_progress;
    if (auto s = render::draw(*session_, out.request, *plan, {in_.pool, no_progress}, rendered); !s)
        return tl::unexpected(s.error());
    rendered.ms.render = watch.lap_ms();
    if (in_.job.data_set) out.shot = shot_of(session_->job().camera, *plan);
    return out;
}

}  // namespace facet::batch
