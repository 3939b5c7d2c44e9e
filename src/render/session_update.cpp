// A session under other settings: only what they change is done again.
// SPDX-License-Identifier: MIT
#include "render/play.h"
#include "render/rays.h"
#include "render/session.h"
#include "trace/trace.h"

#include <utility>

namespace facet::render {
namespace {

using tables::Settings;

bool edits_differ(const Settings& a, const Settings& b) {
    return a.light != b.light || a.no_file_lights != b.no_file_lights || a.set != b.set ||
           a.material != b.material || a.ground != b.ground;
}

bool time_differs(const Settings& a, const Settings& b) {
    return a.time != b.time || a.animation != b.animation || a.shutter != b.shutter;
}

bool clip_differs(const Settings& a, const Settings& b) {
    return plays_animation(a) != plays_animation(b) || a.animation != b.animation;
}

bool camera_differs(const Settings& a, const Settings& b) {
    return a.camera != b.camera || a.fov != b.fov || a.size != b.size ||
           a.projection != b.projection || a.vignette != b.vignette ||
           a.motion_blur != b.motion_blur || a.distortion != b.distortion ||
           a.aberration != b.aberration || a.aperture != b.aperture || a.focus != b.focus ||
           a.blades != b.blades;
}

bool targets_differ(const frame::FrameSpec& a, const frame::FrameSpec& b) {
    return a.picture != b.picture || a.region.x != b.region.x || a.region.y != b.region.y ||
           a.region.size != b.region.size || a.emissive != b.emissive || a.specular != b.specular ||
           a.rays != b.rays || a.maps != b.maps || a.aovs != b.aovs;
}

bool is_moved(const math::Bounds& a, const math::Bounds& b) {
    return a.low != b.low || a.high != b.high;
}

}  // namespace

base::Status Session::change_scene(const Settings& settings, const Plan& plan) {
    if (auto s = apply_edits(settings, plan, *job_); !s) return s;
    if (auto s = frame::update_scene(*gl_, job_->scene, filtering_of(plan_), *pool_, scene_); !s)
        return s;
    set_lights(job_->scene.lights);
    return {};
}

base::Status Session::change_time(const Settings& settings, const Plan& plan,
                                  base::Warnings& warnings) {
    forget_rays();
    const bool is_other = clip_differs(settings, clip_settings_);
    if (is_other)
        if (auto s = choose_clip(settings, *job_, warnings); !s) return s;
    clip_settings_ = settings;
    const auto posed = pose_job(settings, plan, shutter_middle, *job_);
    if (!posed) return tl::unexpected(posed.error());
    part_ = shutter_middle;
    moved_camera_.reset();
    if (auto s = apply_edits(settings, plan, *job_); !s) return s;
    if (auto s = frame::move_scene(*gl_, job_->scene, filtering_of(plan_), *pool_,
                                   is_other || posed->has_meshes, scene_);
        !s)
        return s;
    set_lights(job_->scene.lights);
    return aim_camera(settings, *job_);
}

base::Status Session::move_to(float part) {
    if (holds_still_ || part == part_ || !blurs_animation(settings_, *job_)) return {};
    forget_indirect();
    const auto posed = pose_job(settings_, plan_, part, *job_);
    if (!posed) return tl::unexpected(posed.error());
    if (posed->has_lights) set_lights(job_->scene.lights);
    if (auto s = frame::move_scene(*gl_, job_->scene, filtering_of(plan_), *pool_,
                                   posed->has_meshes, scene_);
        !s)
        return s;
    if (tracer_)
        if (auto s = tracer_->follow_scene(plan_.limits); !s) return s;
    part_ = part;
    has_moved_ = true;
    moved_camera_ = camera_at(settings_, part, *job_);
    return {};
}

base::Status Session::change(const Settings& settings, const Plan& plan, base::Warnings& warnings) {
    forget_indirect();
    const Settings before = std::exchange(settings_, settings);
    const Plan plan_before = std::exchange(plan_, plan);
    key_light_.reset();
    job_->env_rotation_deg = settings.env_rotation;
    const bool new_filtering = !(filtering_of(plan) == filtering_of(plan_before));
    const bool new_brdf = !(plan.brdf == plan_before.brdf);
    const math::Bounds seen_before = job_->scene.seen_bounds_m();
    const bool new_environment = settings.env != before.env;
    const bool new_light = new_environment || settings.env_rotation != before.env_rotation ||
                           settings.env_intensity != before.env_intensity;
    if (edits_differ(settings, before) || new_brdf || new_light || settings.probe != before.probe)
        forget_rays();
    // Samples of a blurred picture leave the scene at the last one's time.
    if (time_differs(settings, before) || part_ != shutter_middle)
        if (auto s = change_time(settings, plan, warnings); !s) return s;
    if (!(plan.rays == plan_before.rays) || settings.seed != before.seed) rays_.reset();
    if (edits_differ(settings, before) || new_filtering)
        if (auto s = change_scene(settings, plan); !s) return s;
    // Lights that are seen move the depth range.
    if (camera_differs(settings, before) || is_moved(seen_before, job_->scene.seen_bounds_m()))
        if (auto s = aim_camera(settings, *job_); !s) return s;
    if (new_environment)
        if (auto s = load_environment(settings, plan, *pool_, assets_, *job_); !s) return s;
    if (new_brdf || new_light) {
        // Nothing is kept of what is turned and dimmed on the way: there may be hundreds of it.
        if (auto s = upload_environment({}, warnings); !s) return s;
        pack_lights();
    }
    if (new_brdf) return make_frame();
    if (targets_differ(frame_spec(), frame_->spec())) return frame_->resize(*gl_, frame_spec());
    return {};
}

base::Status Session::look(const scene::Camera& camera, const frame::Region& region,
                           math::Extent picture) {
    forget_indirect();
    job_->camera = camera;
    moved_camera_.reset();
    if (part_ != shutter_middle) moved_camera_ = camera_at(settings_, part_, *job_);
    plan_.region = region;
    plan_.picture = picture.pixels() > 0 ? picture : region.size;
    explainer_.reset();
    if (targets_differ(frame_spec(), frame_->spec())) return frame_->resize(*gl_, frame_spec());
    return {};
}

base::Status Session::enter(Job job, const Settings& settings, const Plan& plan,
                            base::Warnings& warnings) {
    const bool has_frame = frame_.has_value() && plan.brdf == plan_.brdf;
    forget_rays();
    job_ = std::make_unique<Job>(std::move(job));
    settings_ = settings;
    clip_settings_ = settings;
    plan_ = plan;
    explainer_.reset();
    part_ = shutter_middle;
    moved_camera_.reset();
    scene_ = {};  // before the next one needs the memory
    auto scene = frame::upload_scene(*gl_, job_->scene, filtering_of(plan_), *pool_);
    if (!scene) return tl::unexpected(scene.error());
    scene_ = std::move(*scene);
    if (auto s = upload_environment(job_->cache_folder, warnings); !s) return s;
    set_lights(job_->scene.lights);
    if (!has_frame) return make_frame();
    if (targets_differ(frame_spec(), frame_->spec())) return frame_->resize(*gl_, frame_spec());
    return {};
}

base::Status Session::update(const Settings& settings, const Plan& plan, base::Warnings& warnings) {
    const Settings before = settings_;
    const Plan plan_before = plan_;
    explainer_.reset();  // of the targets and settings before
    auto changed = change(settings, plan, warnings);
    if (changed) return changed;
    // Back again: what failed left its part as it was, what came before it did not.
    if (auto back = change(before, plan_before, warnings); !back) return back;
    return changed;
}

base::Result<std::vector<image::Layer>> Session::probe(const frame::Region& region,
                                                       const std::vector<tables::Aov>& aovs) {
    frame::FrameSpec spec = frame_spec();
    spec.region = region;
    spec.aovs = aovs;
    if (!probe_) {
        auto made = frame::Frame::create(*gl_, *sources_, spec);
        if (!made) return tl::unexpected(made.error());
        probe_ = std::move(*made);
    } else if (auto s = probe_->resize(*gl_, spec); !s) {
        return tl::unexpected(s.error());
    }
    const scene::KeyLight key = key_light_for(aovs);
    if (auto s = probe_->draw(*gl_, inputs(key), 0, 1); !s) return tl::unexpected(s.error());
    if (auto s = probe_->draw_centered_aovs(*gl_, inputs(key)); !s)
        return tl::unexpected(s.error());
    return probe_->read_aovs(*gl_, 1);
}

base::Status Session::reload_shaders() {
    auto old_frame = std::exchange(frame_, std::nullopt);
    auto old_sources = std::exchange(sources_, nullptr);
    auto made = make_frame();
    // Programs are compiled at first need: only a picture tells that they all are right.
    const scene::KeyLight key = key_light_for(plan_.aovs);
    if (made) made = frame_->draw(*gl_, inputs(key), 0, 1);
    if (made) made = frame_->draw_centered_aovs(*gl_, inputs(key));
    if (made) made = display(1.0, 1);
    if (made) return made;
    frame_ = std::move(old_frame);
    sources_ = std::move(old_sources);
    return made;
}

}  // namespace facet::render
