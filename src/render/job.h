// What a picture is made of, loaded: scene with the user's changes, environment, camera.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "render/assets.h"
#include "render/plan.h"
#include "render/render.h"
#include "scene/environment.h"
#include "scene/key_light.h"
#include "scene/rig.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace facet::render {

/// What the settings change in a scene, as it was loaded.
struct Originals {
    std::vector<scene::Material> materials;
    std::vector<scene::Light> lights;
};

/// Times of a picture run from 0, where the shutter opens, to 1, where it closes.
inline constexpr float shutter_middle = 0.5F;

struct Job {
    scene::Scene scene;
    Originals originals;
    scene::Environment environment;
    scene::Camera camera;               ///< in the middle of the shutter's time
    const scene::Clip* clip = nullptr;  ///< that is played; the scene's rig has it
    float env_rotation_deg = 0.0F;
    std::optional<std::size_t> named_light;  ///< the first --light among the scene's
    base::Warnings warnings;
    std::vector<std::filesystem::path> reads;
    std::filesystem::path cache_folder;  ///< the request's
};

/// How the settings say that a scene is loaded.
[[nodiscard]] scene::LoadOptions load_options(const tables::Settings& settings);

/// Loads, applies --no-file-lights, --light and --set, and resolves the camera. `assets`: where
/// files are looked for that are read already; may be null.
[[nodiscard]] base::Result<Job> load_job(const Request& request, const Plan& plan,
                                         base::ThreadPool& pool, Assets* assets = nullptr);

/// Makes the job's materials and lights anew: those loaded, with what the settings change. On an
/// error the job is as it was.
[[nodiscard]] base::Status apply_edits(const tables::Settings& settings, const Plan& plan,
                                       Job& job);
/// Loads the environment that the settings name; `assets` as above.
[[nodiscard]] base::Status load_environment(const tables::Settings& settings, const Plan& plan,
                                            base::ThreadPool& pool, Assets* assets, Job& job);
/// Resolves the camera that the settings name.
[[nodiscard]] base::Status aim_camera(const tables::Settings& settings, Job& job);
/// The light that AOVs of the BRDF's terms are for; not looked for where none of them is wanted.
[[nodiscard]] scene::KeyLight key_light(const Job& job, std::span<const tables::Aov> aovs);

}  // namespace facet::render
