// Further outputs of the reference: what the camera's rays meet first.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/read.h"
#include "tables/aovs.h"
#include "trace/camera.h"
#include "trace/path.h"
#include "trace/trace.h"

#include <vector>

namespace facet::trace {

/// What the rows of tables/aovs.def take their values from; named as in glsl/frame/aov/aov.frag.
struct AovSurface {
    math::Vec3 albedo{0.0F};
    math::Vec3 normal{0.0F};
    float metallic = 0.0F;
    float roughness = 0.0F;
    math::Vec3 dielectric_f0{0.0F};
    float specular = 1.0F;
    float ao = 0.0F;
    math::Vec3 emissive{0.0F};
    math::Vec3 position_m{0.0F};
    float depth_m = 0.0F;
    std::uint32_t object_id = 0;
    std::uint32_t material_id = 0;
    float n_dot_v = 0.0F;
    float n_dot_l = 0.0F;
    float n_dot_h = 0.0F;
    float v_dot_h = 0.0F;
    Lobes::BrdfTerms brdf{};
};
/// Of one row: rows that are light paths are of `paths`, the others of `surface`.
[[nodiscard]] math::Vec3 aov_value(tables::Aov aov, const AovSurface& surface,
                                   const LightPaths& paths = {});

/// One f32 layer an AOV. Rows averaged by mean take `settings.samples` rays, 16 at most, the others
/// one through the pixel's centre; where nothing is met the value is 0, and infinite for depth.
/// Blended surfaces are passed, as the G-buffer leaves them out. Light paths are Film's, not ours.
[[nodiscard]] std::vector<image::Layer> trace_aovs(const World& world, const CameraRays& camera,
                                                   const TraceSettings& settings,
                                                   const std::vector<tables::Aov>& aovs,
                                                   base::ThreadPool& pool);

}  // namespace facet::trace
