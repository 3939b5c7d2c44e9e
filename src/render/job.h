// What a picture is made of, loaded: scene with the user's changes, environment, camera.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "render/plan.h"
#include "render/render.h"
#include "scene/environment.h"
#include "scene/scene.h"

#include <filesystem>
#include <vector>

namespace facet::render {

struct Job {
    scene::Scene scene;
    scene::Environment environment;
    scene::Camera camera;
    base::Warnings warnings;
    std::vector<std::filesystem::path> reads;
};

/// Loads, applies --no-file-lights, --light and --set, and resolves the camera.
[[nodiscard]] base::Result<Job> load_job(const Request& request, const Plan& plan,
                                         base::ThreadPool& pool);

}  // namespace facet::render
