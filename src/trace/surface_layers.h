// What few surfaces have: maps of normals, and the lobes that the G-buffer does not hold.
// SPDX-License-Identifier: MIT
#pragma once

#include "trace/surface_point.h"

namespace facet::trace {

struct ShadingNormal {
    math::Vec3 normal;  ///< turned to the viewer
    float bumps;        ///< for with_bumps()
};
struct NormalSlot {
    tables::TextureSlot slot;
    float scale;
};
/// With the map in `map`: after the sides.
[[nodiscard]] ShadingNormal shading_normal(const scene::Scene& scene,
                                           const math::Mat3& normal_from_object, const Point& point,
                                           const NormalSlot& map, const Surface& s);

/// The roughness that a surface has where bumps are too fine to be seen: glsl/lib/material.glsl's.
[[nodiscard]] float with_bumps(float roughness, float bumps);

/// glsl/lib/material.glsl's. After the normal, before its bumps are in the roughness.
void fill_layers(const scene::Scene& scene, const math::Mat3& normal_from_object,
                 const Point& point, const math::Vec3& to_eye, Surface& s);

/// Of thin and smooth glass, straight_share() needs this alone.
void fill_transmission(const Point& point, Surface& s);

}  // namespace facet::trace
