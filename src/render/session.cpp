// A scene on the GL, ready to be drawn as often as wanted.
// SPDX-License-Identifier: MIT
#include "render/session.h"

#include "base/resources.h"
#include "brdf/albedo.h"
#include "brdf/glsl_text.h"
#include "frame/output/exposure.h"
#include "render/play.h"
#include "render/rays.h"
#include "render/stopwatch.h"
#include "scene/sun.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>

namespace facet::render {

/// Paths of a pixel's middle for each sample of a picture whose scene moves meanwhile, and how far
/// apart such pixels are.
constexpr std::uint32_t blurred_samples = 2;
constexpr std::uint32_t blurred_stride = 2;

base::Result<Opened> open(const Request& request, const Plan& plan, base::ThreadPool& pool,
                          base::Log& log, Rendered& out) {
    Stopwatch watch;
    // The context comes up while the files are read: it waits for the driver, they for the decoder.
    auto loading = std::async(std::launch::async, [&] { return load_job(request, plan, pool); });
    auto gl = gl::Context::create(plan.backend, log);
    auto job = loading.get();
    if (!job) return tl::unexpected(job.error());
    if (!gl) return tl::unexpected(gl.error());
    out.size = plan.region.size;
    out.ms.load = watch.lap_ms();
    out.backend = gl->backend() + " (" + gl->renderer() + ")";
    out.triangles = job->scene.triangle_count();
    out.materials = job->originals.materials.size();
    out.warnings = job->warnings;
    out.reads = job->reads;
    return Opened{std::move(*gl), std::move(*job)};
}

base::Result<Session> Session::create(const gl::Context& gl, Job job,
                                      const tables::Settings& settings, const Plan& plan,
                                      base::ThreadPool& pool, base::Warnings& warnings) {
    Session session(gl, pool);
    if (auto s = session.enter(std::move(job), settings, plan, warnings); !s)
        return tl::unexpected(s.error());
    return session;
}

frame::Filtering filtering_of(const Plan& plan) {
    // A sample of n stands for a width of 1 / sqrt(n): the reference's, which has a least width
    // too.
    constexpr float finest = -3.0F;
    return {
        .is_fast = plan.is_draft,
        .level_bias = std::max(finest, -0.5F * std::log2(static_cast<float>(plan.sample_count)))};
}

frame::FrameSpec Session::frame_spec() const {
    return {.picture = plan_.picture,
            .region = plan_.region,
            .emissive = scene_.emits,
            .specular = scene_.has_specular,
            .rays = plan_.rays.any(),
            .maps = plan_.has_maps,
            .aovs = plan_.aovs};
}

base::Status Session::upload_environment(const std::filesystem::path& cache_folder,
                                         base::Warnings& warnings) {
    const auto is_wanted = [&](const Baked& baked) {
        return baked.latlong == job_->environment.latlong && baked.brdf == plan_.brdf &&
               baked.rotation_deg == settings_.env_rotation &&
               baked.intensity == settings_.env_intensity;
    };
    const auto known = std::ranges::find_if(baked_, is_wanted);
    if (known != baked_.end()) {
        std::rotate(baked_.begin(), known, known + 1);
        const base::Warnings& old = baked_.front().warnings;
        warnings.insert(warnings.end(), old.begin(), old.end());
        return {};
    }
    const brdf::AlbedoTable table = brdf::albedo_table(plan_.brdf);
    base::Warnings own;
    scene::SplitEnvironment split = scene::split_sun(job_->environment);
    const frame::EnvironmentSettings turned{settings_.env_rotation, settings_.env_intensity,
                                            cache_folder};
    auto maps =
        frame::upload_environment(*gl_, split.rest, turned, table.texels, table.size, *pool_, own);
    if (!maps) return tl::unexpected(maps.error());
    if (split.sun && turned.intensity > 0.0F)
        maps->sun = scene::turned_sun(*split.sun, turned.rotation_deg, turned.intensity);
    warnings.insert(warnings.end(), own.begin(), own.end());
    baked_.insert(baked_.begin(),
                  {.latlong = job_->environment.latlong,
                   .rest = std::make_shared<scene::Environment>(std::move(split.rest)),
                   .brdf = plan_.brdf,
                   .rotation_deg = turned.rotation_deg,
                   .intensity = turned.intensity,
                   .maps = std::move(*maps),
                   .warnings = std::move(own)});
    if (baked_.size() > most_baked) baked_.pop_back();
    return {};
}

scene::KeyLight Session::key_light_for(const std::vector<tables::Aov>& aovs) {
    if (!tables::any_of_kind(aovs, tables::AovKind::key_light)) return {};
    if (!key_light_) key_light_ = key_light(*job_, aovs);
    return *key_light_;
}

base::Status Session::make_frame() {
    const auto folder = base::data_folder();
    if (!folder) return tl::unexpected(folder.error());
    auto brdf_text = brdf::glsl_text(plan_.brdf);
    if (!brdf_text) return tl::unexpected(brdf_text.error());
    auto sources = std::make_unique<gl::ShaderSources>();
    *sources = {*folder / "glsl", {{"generated/brdf.glsl", *brdf_text}}};
    auto frame = frame::Frame::create(*gl_, *sources, frame_spec());
    if (!frame) return tl::unexpected(frame.error());
    frame_ = std::move(*frame);
    probe_.reset();
    explainer_.reset();
    sources_ = std::move(sources);
    return {};
}

/// A question to rays, on its way.
struct AskedRays {
    std::future<base::Status> status;
    frame::IndirectLight light;
};

Session::Session(const gl::Context& gl, base::ThreadPool& pool) : gl_(&gl), pool_(&pool) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() { forget_indirect(); }

frame::FrameInputs Session::inputs(const scene::KeyLight& key, bool with_rays) const {
    const bool has_rays = with_rays && rays_ != nullptr;
    return {scene_,
            baked_.front().maps,
            has_rays ? *ray_lights_ : *lights_,
            moved_camera_ ? *moved_camera_ : job_->camera,
            plan_.background,
            key,
            has_rays ? nullptr : probe_maps_.get(),
            has_rays ? rays_.get() : nullptr,
            job_->scene.ground ? &*job_->scene.ground : nullptr,
            lights_.get(),
            has_moved_};
}

void Session::forget_indirect() {
    has_indirect_ = false;
    if (!asked_) return;
    if (rays_) rays_->cancel();
    asked_->status.wait();
    asked_.reset();
    rays_.reset();
}

void Session::forget_rays() {
    forget_indirect();
    probe_maps_.reset();
    rays_.reset();
    tracer_.reset();
}

base::Status Session::make_rays() {
    if (!plan_.rays.any()) rays_.reset();
    if (!plan_.rays.any() || rays_) return {};
    if (!tracer_) {
        auto made = trace::Tracer::create({.scene = job_->scene,
                                           .environment = *baked_.front().rest,
                                           .camera = job_->camera,
                                           .env_rotation_deg = settings_.env_rotation,
                                           .env_intensity = settings_.env_intensity,
                                           .brdf = plan_.brdf,
                                           .sun = sun()},
                                          plan_.limits, *pool_);
        if (!made) return tl::unexpected(made.error());
        tracer_ = std::make_unique<trace::Tracer>(std::move(*made));
    }
    tables::RayBudget budget = plan_.rays;
    if (blurs_animation(settings_, *job_)) {
        // Every sample finds light of its own, and the picture has their mean.
        budget.samples = std::min(budget.samples, blurred_samples);
        budget.most_samples = std::min(budget.most_samples, 2 * blurred_samples);
        budget.stride = std::max(budget.stride, blurred_stride);
    }
    rays_ = std::make_unique<TracedRays>(RayScene{*tracer_, scene_, *ray_lights_}, budget,
                                         plan_.sample_count, settings_.seed, *pool_);
    return {};
}

base::Status Session::ask_rays() {
    forget_indirect();
    if (auto made = make_rays(); !made) return made;
    if (!rays_ || !rays_->has_indirect()) return {};
    const scene::KeyLight key = key_light_for(plan_.aovs);
    auto surfaces = frame_->read_middles(*gl_, inputs(key));
    if (!surfaces) return tl::unexpected(surfaces.error());
    rays_->look_at(*surfaces);
    asked_ = std::make_unique<AskedRays>();
    asked_->status = std::async(std::launch::async, [this]() -> base::Status {
        asked_->light = rays_->indirect(baked_.front().maps);
        return {};
    });
    return {};
}

Session::Asked Session::asked() const {
    if (!asked_) return Asked::no;
    const auto state = asked_->status.wait_for(std::chrono::seconds(0));
    return state == std::future_status::ready ? Asked::done : Asked::running;
}

base::Status Session::take_rays() {
    if (!asked_) return {};
    auto status = asked_->status.get();
    if (status) status = frame_->set_indirect(*gl_, asked_->light);
    asked_.reset();
    has_indirect_ = status.has_value();
    return status;
}

base::Status Session::draw(std::uint32_t index, std::uint32_t count, frame::PassTimes* times,
                           bool with_rays) {
    if (auto moved = move_to(frame::sample_time(index, count)); !moved) return moved;
    if (with_rays) {
        if (asked_) forget_indirect();
        if (auto made = make_rays(); !made) return made;
    }
    if (plan_.has_probe && !plan_.rays.any() && !probe_maps_)
        if (auto captured = capture_probe(); !captured) return captured;
    const scene::KeyLight key = key_light_for(plan_.aovs);
    const frame::FrameInputs in = inputs(key, with_rays);
    if ((index == 0 || has_moved_) && with_rays && !has_indirect_)
        if (auto found = frame_->find_indirect(*gl_, in); !found) return found;
    auto drawn = frame_->draw(*gl_, in, index, count, times);
    has_moved_ = false;
    return drawn;
}

base::Status Session::draw_centered_aovs() {
    if (auto moved = move_to(shutter_middle); !moved) return moved;
    return frame_->draw_centered_aovs(*gl_, inputs(key_light_for(plan_.aovs)));
}

base::Result<std::vector<frame::ExplainedPixel>> Session::explain(
    std::span<const frame::PixelPlace> pixels, std::uint32_t index, std::uint32_t count) {
    if (!explainer_) {
        auto made = frame::Explainer::create(*gl_, *sources_, frame_spec());
        if (!made) return tl::unexpected(made.error());
        explainer_ = std::move(*made);
    }
    forget_indirect();
    if (auto moved = move_to(frame::sample_time(index, count)); !moved)
        return tl::unexpected(moved.error());
    if (auto made = make_rays(); !made) return tl::unexpected(made.error());
    frame::FrameInputs in = inputs({});
    in.has_moved = blurs_animation(settings_, *job_);  // since its own sample before
    return explainer_->draw(*gl_, in, pixels, index, count);
}

double Session::measure_exposure(std::uint32_t count) {
    const math::Extent size = frame_->size();
    std::vector<float> radiance(static_cast<std::size_t>(size.pixels()) * 4);
    gl::read_pixels(*gl_, frame_->sum_framebuffer(), 0, size, {GL_RGBA, GL_FLOAT},
                    std::as_writable_bytes(std::span(radiance)));
    return frame::auto_exposure(radiance, read_depth(), count, *pool_);
}

std::vector<float> Session::read_depth() const {
    const math::Extent size = frame_->size();
    std::vector<float> depth(static_cast<std::size_t>(size.pixels()));
    gl::read_pixels(*gl_, frame_->depth_framebuffer(), 0, size, {GL_DEPTH_COMPONENT, GL_FLOAT},
                    std::as_writable_bytes(std::span(depth)));
    return depth;
}

frame::DisplaySettings Session::display_settings(double exposure, std::uint32_t count) const {
    frame::DisplaySettings settings{
        .tonemap = plan_.tonemap,
        .exposure = exposure,
        .frame_count = count,
        .sample = plan_.display_sample,
        .dither = !plan_.is_draft && plan_.display_sample == image::Sample::u8,
        .gamut = plan_.gamut,
        .balance = plan_.balance};
    if (plan_.background.kind == frame::BackgroundKind::color)
        settings.background = plan_.background.color;
    return settings;
}

base::Status Session::display(double exposure, std::uint32_t count) {
    return frame_->display(*gl_, display_settings(exposure, count));
}

base::Status Session::display_picture(const image::Image& radiance, double exposure) {
    return frame_->display_picture(*gl_, radiance, display_settings(exposure, 1));
}

void Session::lay_over_background(image::Image& radiance, double exposure) const {
    if (plan_.background.kind != frame::BackgroundKind::color) return;
    const math::Vec3 under = plan_.background.color / static_cast<float>(exposure);
    const auto values = radiance.as<float>();
    for (std::size_t i = 0; i < values.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c)
            values[i + c] += under[static_cast<int>(c)] * (1.0F - values[i + 3]);
        values[i + 3] = 1.0F;
    }
}

void Session::set_lights(std::span<const scene::Light> lights) {
    forget_rays();  // before what they look at changes
    job_->scene.lights = std::vector<scene::Light>(lights.begin(), lights.end());
    key_light_.reset();
    pack_lights();
}

void Session::pack_lights() {
    forget_rays();
    std::vector<scene::Light> lights = job_->scene.lights;
    if (sun()) lights.push_back(*sun());
    lights_ = std::make_unique<frame::PackedLights>(frame::pack_lights(lights, false));
    ray_lights_ = std::make_unique<frame::PackedLights>(frame::pack_lights(lights, true));
}

image::Image Session::read_mean(std::uint32_t count) const {
    image::Image mean = frame::read_radiance(*gl_, frame_->sum_framebuffer(), frame_->size());
    const float share = 1.0F / static_cast<float>(count);
    for (float& value : mean.as<float>()) value *= share;
    return mean;
}

void Session::lay_over_background(std::vector<image::Layer>& aovs, const image::Image& radiance,
                                  double exposure) const {
    if (plan_.background.kind != frame::BackgroundKind::color) return;
    const math::Vec3 under = plan_.background.color / static_cast<float>(exposure);
    const auto beauty = radiance.as<float>();
    for (image::Layer& layer : aovs) {
        if (layer.name != tables::row(tables::Aov::background).key) continue;
        const auto values = layer.image.as<float>();
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] += under[static_cast<int>(i % 3)] * (1.0F - beauty[i / 3 * 4 + 3]);
    }
}

std::vector<image::Layer> Session::read_aovs(double exposure, std::uint32_t count) const {
    std::vector<image::Layer> layers = frame_->read_aovs(*gl_, count);
    const bool is_laid = plan_.background.kind == frame::BackgroundKind::color &&
                         frame_->aov_texture(tables::Aov::background) != nullptr;
    if (is_laid) lay_over_background(layers, read_mean(count), exposure);
    return layers;
}

}  // namespace facet::render
