// The animation of a job: which clip is played, and the job at a time of it.
// SPDX-License-Identifier: MIT
#pragma once

#include "render/job.h"
#include "scene/animate.h"

namespace facet::render {

/// Finds the clip that the settings ask for, and aims cameras at the scene as it begins; the scene
/// is left at some pose. Errors: usage (no such clip), those of the clip.
[[nodiscard]] base::Status choose_clip(const tables::Settings& settings, Job& job,
                                       base::Warnings& warnings);

/// Whether what moves is seen moving.
[[nodiscard]] bool blurs_animation(const tables::Settings& settings, const Job& job);

struct Posed {
    bool has_meshes = false;  ///< vertices or triangles are other ones
    bool has_lights = false;  ///< lights are elsewhere, and were edited again
};
/// Puts the job's scene where the clip has it at `part` of the shutter's time; its camera stays.
/// Errors: as apply_edits().
[[nodiscard]] base::Result<Posed> pose_job(const tables::Settings& settings, const Plan& plan,
                                           float part, Job& job);
/// The job's camera at `part` of the shutter's time, where a node of the file carries it.
[[nodiscard]] scene::Camera camera_at(const tables::Settings& settings, float part, const Job& job);

}  // namespace facet::render
