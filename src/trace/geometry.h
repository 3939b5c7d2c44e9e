// The triangles of a scene as rays meet them: the only room's file that names Embree.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"
#include "scene/scene.h"
#include "trace/textures.h"

#include <cstdint>
#include <memory>

namespace facet::trace {

struct Ray {
    math::Vec3 origin{0.0F};
    math::Vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit
    float near_m = 0.0F;
    float far_m = 1e30F;
};

/// Where a ray met a triangle. The point is a (1 - u - v) + b u + c v of the triangle a, b, c.
struct Hit {
    std::uint32_t instance = 0;  ///< index of Scene::instances
    std::uint32_t triangle = 0;  ///< of its mesh
    math::Vec3 normal{0.0F};     ///< of the triangle: not unit, twice its area long, front side
    float distance_m = 0.0F;
    float u = 0.0F;
    float v = 0.0F;
};

/// Surfaces that let one ray through: more than any picture shows.
inline constexpr std::uint32_t most_passed = 256;
/// What is left of a ray that a hit let through, free of that triangle.
[[nodiscard]] Ray behind(const Ray& ray, const Hit& hit);

/// Who looks: the camera does not see the back of what is single-sided, as the rasteriser culls it.
enum class Viewer : std::uint8_t { camera, light };

class Geometry {
public:
    /// Every instance in world space. `scene` and `textures` outlive this. Errors: limit_reached
    /// (memory), internal.
    [[nodiscard]] static base::Result<Geometry> build(const scene::Scene& scene,
                                                      const Textures& textures,
                                                      const base::Limits& limits);
    Geometry(Geometry&&) noexcept;
    Geometry& operator=(Geometry&&) noexcept;
    ~Geometry();

    /// The nearest triangle whose alpha mask is not a hole there. False where there is none.
    /// Blended surfaces count.
    [[nodiscard]] bool intersect(const Ray& ray, Viewer viewer, Hit& hit) const;
    /// Share of light that gets through, [0, 1] by channel: 0 behind anything opaque and what bends
    /// light, less by each blended surface's opacity, and by thin smooth glass.
    [[nodiscard]] math::Vec3 transmittance(const Ray& ray) const;

private:
    struct Impl;
    explicit Geometry(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace facet::trace
