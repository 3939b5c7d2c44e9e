// The light that arrives along one camera ray: path tracing (Kajiya 1986) with next-event
// estimation and multiple importance sampling (Veach 1997). SPDX-License-Identifier: MIT
#pragma once

#include "scene/key_light.h"
#include "trace/bsdf.h"
#include "trace/environment_light.h"
#include "trace/geometry.h"
#include "trace/light_paths.h"
#include "trace/lights.h"
#include "trace/sequence.h"
#include "trace/surface.h"
#include "trace/textures.h"

namespace facet::trace {

/// Everything a path meets; references outlive the call.
struct World {
    const scene::Scene& scene;
    const std::vector<InstanceFrame>& frames;
    const Textures& textures;
    const Geometry& geometry;
    const Lights& lights;
    const EnvironmentLight& environment;
    const Model& model;
    bool shows_environment = false;  ///< where the camera sees no surface
    float blur =
        0.0F;  ///< of the environment there: a GGX lobe of this roughness, as the rasteriser's
    std::uint32_t bounce_limit = 64;
    scene::KeyLight key_light{};        ///< for AOVs that are terms of the BRDF
    const scene::Light* sun = nullptr;  ///< behind the scene's lights
    math::Vec3 open_ground{
        0.0F};  ///< irradiance / pi of level ground by the sky, if nothing stood there
    [[nodiscard]] const scene::Light& light(std::size_t index) const {
        return index < scene.lights.size() ? scene.lights[index] : *sun;
    }
};

/// What one ray stands for: its width at its origin in metres, and how much wider it gets per
/// metre.
struct Cone {
    float width_m = 0.0F;
    float spread = 0.0F;
    [[nodiscard]] float width_at(float distance_m) const { return width_m + spread * distance_m; }
};

struct PathLight {
    math::Vec3 radiance_nit{0.0F};
    float coverage = 0.0F;  ///< 1 where the ray met a surface, or an environment that is shown
    std::uint32_t rays = 0;
};

/// `apart`, unless null, gets the same light by the way that it took; the rays are the same.
[[nodiscard]] PathLight trace_path(const World& world, const Ray& camera_ray, Cone cone,
                                   Sequence& sequence, LightPaths* apart = nullptr);

/// Light that one draw brings to a surface and that it sends to the viewer, in nit: of the sky, of
/// meshes that emit, and by way of other surfaces; not of listed lights at once.
struct Gathered {
    math::Vec3 diffuse_sky{0.0F};   ///< of the sky at once
    math::Vec3 diffuse_open{0.0F};  ///< what that would be if nothing stood in the way
    math::Vec3 diffuse_rest{0.0F};
    math::Vec3 specular_sky{0.0F};
    math::Vec3 specular_open{0.0F};
    math::Vec3 specular_rest{0.0F};
};
/// A place on the ground, and the irradiance / pi there if nothing stood on it.
struct GroundPlace {
    math::Vec3 position_m;
    math::Vec3 open_nit;
};
/// By how much the scene changes the light on level white ground, of what it would be without: 1
/// where it changes nothing, and then exactly, for any draw. `cone`: of a pixel there.
[[nodiscard]] math::Vec3 ground_share(const World& world, const GroundPlace& place, Cone cone,
                                      Sequence& sequence, std::uint32_t& rays);
/// Adds one draw to `out`. `cone`: of a pixel at the surface. Returns the number of rays.
std::uint32_t gather_light(const World& world, const Surface& surface, const math::Vec3& to_eye,
                           Cone cone, Sequence& sequence, Gathered& out,
                           Bsdf::Draws draws = Bsdf::Draws::both);

}  // namespace facet::trace
