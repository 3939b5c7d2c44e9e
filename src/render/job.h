// What a picture is made of, loaded: scene with the user's changes, environment, camera.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "render/plan.h"
#include "render/render.h"
#include "scene/environment.h"
#include "scene/key_light.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace facet::render {

struct Job {
    scene::Scene scene;
    scene::Environment environment;
    scene::Camera camera;
    float env_rotation_deg = 0.0F;
    std::optional<std::size_t> named_light;  ///< the first --light among the scene's
    base::Warnings warnings;
    std::vector<std::filesystem::path> reads;
};

/// Loads, applies --no-file-lights, --light and --set, and resolves the camera.
[[nodiscard]] base::Result<Job> load_job(const Request& request, const Plan& plan,
                                         base::ThreadPool& pool);

/// The light that AOVs of the BRDF's terms are for; not looked for where none of them is wanted.
[[nodiscard]] scene::KeyLight key_light(const Job& job, std::span<const tables::Aov> aovs);

}  // namespace facet::render
