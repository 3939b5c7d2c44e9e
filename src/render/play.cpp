// The animation of a job.
// SPDX-License-Identifier: MIT
#include "render/play.h"

#include "scene/light_shapes.h"
#include "scene/relief.h"

#include <utility>

namespace facet::render {
namespace {

scene::Pose pose_of(const tables::Settings& settings, float part, const Job& job) {
    const auto open_s = static_cast<double>(settings.shutter.value_or(0.0F));
    const double time_s = static_cast<double>(settings.time.value_or(0.0F)) +
                          (static_cast<double>(part) - 0.5) * open_s;
    return scene::pose_at(*job.scene.rig, job.clip, time_s);
}

}  // namespace

base::Status choose_clip(const tables::Settings& settings, Job& job, base::Warnings& warnings) {
    const scene::Clip* clip = nullptr;
    if (plays_animation(settings)) {
        const auto found = scene::find_clip(job.scene, settings.animation);
        if (!found) {
            base::Error error = found.error();
            if (error.code == base::ErrorCode::usage) error.file = "--animation";
            return base::fail(std::move(error));
        }
        clip = *found;
    }
    const bool was_played = std::exchange(job.clip, clip) != nullptr;
    job.scene.aimed_m.reset();
    if (job.clip == nullptr && plays_animation(settings))
        warnings.push_back({.where = "--time", .what = "the file has no animation"});
    if (job.clip == nullptr && !was_played) return {};
    const scene::Pose first = scene::pose_at(*job.scene.rig, job.clip, 0.0);
    scene::take_pose(first, job.scene);
    scene::take_pose(first, job.originals.lights);
    if (job.clip != nullptr) job.scene.aimed_m = job.scene.bounds_m();
    return {};
}

bool blurs_animation(const tables::Settings& settings, const Job& job) {
    return job.clip != nullptr && settings.shutter.has_value();
}

base::Result<Posed> pose_job(const tables::Settings& settings, const Plan& plan, float part,
                             Job& job) {
    Posed out;
    if (job.clip == nullptr) return out;
    const scene::Pose pose = pose_of(settings, part, job);
    out.has_meshes = scene::take_pose(pose, job.scene);
    scene::raise_reliefs(job.scene);
    out.has_lights = scene::take_pose(pose, job.originals.lights);
    if (!out.has_lights) {
        scene::place_light_shapes(job.scene);
        return out;
    }
    if (auto edited = apply_edits(settings, plan, job); !edited)
        return tl::unexpected(edited.error());
    return out;
}

scene::Camera camera_at(const tables::Settings& settings, float part, const Job& job) {
    if (part == shutter_middle || job.scene.rig == nullptr) return job.camera;
    return scene::carried(job.camera, pose_of(settings, shutter_middle, job),
                          pose_of(settings, part, job));
}

}  // namespace facet::render
