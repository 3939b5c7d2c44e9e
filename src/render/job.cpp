// What a picture is made of, loaded.
// SPDX-License-Identifier: MIT
#include "render/job.h"

#include "base/file.h"
#include "render/play.h"
#include "scene/camera_spec.h"
#include "scene/lens.h"
#include "scene/light_shapes.h"
#include "scene/light_spec.h"
#include "scene/load.h"
#include "scene/material_file.h"
#include "scene/motion.h"
#include "scene/relief.h"
#include "scene/set_path.h"

#include <utility>

namespace facet::render {
namespace {

base::Result<scene::Loaded> load_scene(const Request& request, const Plan& plan,
                                       base::ThreadPool& pool, Assets* assets) {
    const tables::Settings& settings = request.settings;
    const scene::LoadOptions options = load_options(settings);
    if (assets != nullptr) {
        const auto shared = assets->scene(request.scene, options, plan.limits, pool);
        if (!shared) return tl::unexpected(shared.error());
        return **shared;
    }
    if (request.scene != "-") return scene::load(request.scene, options, plan.limits, pool);
    const auto bytes = base::read_stdin(plan.limits.file_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    return scene::load_bytes(*bytes, "-", options, plan.limits, pool);
}

base::Status add_lights(const tables::Settings& settings, scene::Scene& scene) {
    if (settings.no_file_lights) scene.lights.clear();
    for (const std::string& text : settings.light) {
        auto light = scene::parse_light(text);
        if (!light) return tl::unexpected(base::in_file(light.error(), "--light"));
        scene.lights.push_back(std::move(*light));
    }
    return {};
}

/// As wide as shadows of a sun five degrees high.
std::optional<scene::Ground> ground_below(const scene::Scene& scene, const Plan& plan) {
    if (!plan.has_ground) return std::nullopt;
    constexpr float diagonals = 12.0F;
    const math::Bounds bounds = scene.aimed_bounds_m();
    if (bounds.is_empty()) return std::nullopt;
    const math::Vec3 center = bounds.center();
    return scene::Ground{.height_m = plan.ground_m.value_or(bounds.low.y),
                         .radius_m = diagonals * bounds.diagonal(),
                         .center_m = {center.x, center.z}};
}

base::Status edit(const tables::Settings& settings, const Plan& plan, scene::Scene& scene) {
    if (auto added = add_lights(settings, scene); !added) return added;
    for (const std::string& text : settings.material)
        if (auto set = scene::apply_material_setting(scene, text, plan.limits); !set)
            return tl::unexpected(base::in_file(set.error(), "--material"));
    for (const std::string& text : settings.set)
        if (auto set = scene::apply_set(scene, text, plan.limits); !set)
            return tl::unexpected(base::in_file(set.error(), "--set"));
    return {};
}

/// What the settings say of the lens, and of the camera's motion.
base::Status set_lens(const tables::Settings& settings, const scene::Scene& scene,
                      scene::Camera& camera) {
    const bool is_orthographic = camera.projection == scene::Projection::orthographic;
    for (const auto& [option, given] : {std::pair{"--aperture", settings.aperture.has_value()},
                                        std::pair{"--vignette", settings.vignette != "off"},
                                        std::pair{"--distortion", settings.distortion != 0.0F},
                                        std::pair{"--aberration", settings.aberration != 0.0F}})
        if (given && is_orthographic)
            return base::fail({.code = base::ErrorCode::usage,
                               .file = option,
                               .what = "an orthographic view has no lens",
                               .remedy = "leave it out, or --projection perspective"});
    const float middle_m = scene::middle_depth_m(camera, scene);
    if (settings.aperture) {
        camera.lens_radius_m = scene::lens_radius_m(camera.yfov_rad, *settings.aperture);
        camera.focus_m = settings.focus.value_or(middle_m);
        camera.blades = settings.blades;
    }
    if (settings.vignette != "off")
        camera.barrel = settings.vignette == "full"
                            ? scene::tight_barrel(camera.yfov_rad, settings.size)
                            : scene::wide_barrel();
    camera.distortion = settings.distortion;
    camera.aberration = settings.aberration;
    if (settings.motion_blur.empty()) return {};
    const math::Vec3 pivot_m(camera.world_from_view * math::Vec4(0.0F, 0.0F, -middle_m, 1.0F));
    const auto motion = scene::parse_motion(settings.motion_blur, pivot_m);
    if (!motion) return tl::unexpected(base::in_file(motion.error(), "--motion-blur"));
    camera.motion = *motion;
    return {};
}

}  // namespace

scene::LoadOptions load_options(const tables::Settings& settings) {
    scene::LoadOptions options{.ignored_required = settings.ignore_required,
                               .variant = settings.variant,
                               .strict = settings.strict};
    options.allowed_folders.assign(settings.allow_read.begin(), settings.allow_read.end());
    if (!settings.base.empty()) options.base_folder = settings.base;
    return options;
}

base::Status apply_edits(const tables::Settings& settings, const Plan& plan, Job& job) {
    scene::Scene& scene = job.scene;
    scene::remove_light_shapes(scene);  // their materials are none of the originals
    auto materials = std::exchange(scene.materials, job.originals.materials);
    auto lights = std::exchange(scene.lights, job.originals.lights);
    auto edited = edit(settings, plan, scene);
    if (edited) {
        job.named_light = settings.light.empty()
                              ? std::nullopt
                              : std::optional(scene.lights.size() - settings.light.size());
    } else {
        scene.materials = std::move(materials);
        scene.lights = std::move(lights);
    }
    scene::raise_reliefs(scene);
    if (edited) scene.ground = ground_below(scene, plan);
    scene::place_light_shapes(scene);
    return edited;
}

base::Status load_environment(const tables::Settings& settings, const Plan& plan,
                              base::ThreadPool& pool, Assets* assets, Job& job) {
    if (assets != nullptr) {
        const auto shared = assets->environment(settings.env, plan.limits, pool);
        if (!shared) return tl::unexpected(base::in_file(shared.error(), "--env"));
        job.environment = (*shared)->environment;
        const base::Warnings& warnings = (*shared)->warnings;
        job.warnings.insert(job.warnings.end(), warnings.begin(), warnings.end());
        return {};
    }
    auto environment = scene::load_environment(settings.env, plan.limits, pool, job.warnings);
    if (!environment) return tl::unexpected(base::in_file(environment.error(), "--env"));
    job.environment = std::move(*environment);
    return {};
}

base::Status aim_camera(const tables::Settings& settings, Job& job) {
    // A panorama that nobody aimed is level, as --env takes it.
    const bool is_level =
        settings.projection == "panorama" && settings.camera == "auto" && job.scene.cameras.empty();
    auto camera = scene::resolve_camera(job.scene, is_level ? "orbit:elevation=0" : settings.camera,
                                        settings.fov, settings.size);
    if (!camera) return tl::unexpected(base::in_file(camera.error(), "--camera"));
    if (!settings.projection.empty())
        scene::set_projection(*camera, job.scene, settings.projection);
    if (auto lens = set_lens(settings, job.scene, *camera); !lens) return lens;
    job.camera = std::move(*camera);
    return {};
}

base::Result<Job> load_job(const Request& request, const Plan& plan, base::ThreadPool& pool,
                           Assets* assets) {
    const tables::Settings& settings = request.settings;
    auto loaded = load_scene(request, plan, pool, assets);
    if (!loaded) return tl::unexpected(loaded.error());
    Job job{.scene = std::move(loaded->scene),
            .env_rotation_deg = settings.env_rotation,
            .warnings = std::move(loaded->warnings),
            .reads = std::move(loaded->reads),
            .cache_folder = request.cache_folder};
    job.originals = {job.scene.materials, job.scene.lights};
    if (auto s = choose_clip(settings, job, job.warnings); !s)
        return tl::unexpected(base::in_file(s.error(), request.scene));
    if (auto posed = pose_job(settings, plan, shutter_middle, job); !posed)
        return tl::unexpected(posed.error());
    if (auto s = apply_edits(settings, plan, job); !s) return tl::unexpected(s.error());
    if (auto s = load_environment(settings, plan, pool, assets, job); !s)
        return tl::unexpected(s.error());
    if (auto s = aim_camera(settings, job); !s) return tl::unexpected(s.error());
    if (plan.has_ground && !plan.rays.any() && !plan.reference)
        job.warnings.push_back({.where = "--ground",
                                .what = "--shadows maps and off find no shadows on the ground",
                                .remedy = "--shadows traced"});
    return job;
}

scene::KeyLight key_light(const Job& job, std::span<const tables::Aov> aovs) {
    if (!tables::any_of_kind(aovs, tables::AovKind::key_light)) return {};
    return scene::key_light({.scene = job.scene,
                             .environment = job.environment,
                             .env_rotation_deg = job.env_rotation_deg,
                             .named = job.named_light});
}

}  // namespace facet::render
