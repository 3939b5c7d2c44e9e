// The lights of a scene as the tracer draws from them: listed ones, and meshes that emit.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.h"
#include "trace/environment_light.h"
#include "trace/geometry.h"
#include "trace/light_shapes.h"
#include "trace/surface.h"
#include "trace/textures.h"

#include <cstdint>
#include <vector>

namespace facet::trace {

/// Share of light that is left after that way.
[[nodiscard]] inline math::Vec3 left_after(const math::Vec3& extinction_per_m, float distance_m) {
    return extinction_per_m == math::Vec3(0.0F) ? math::Vec3(1.0F)
                                                : glm::exp(-extinction_per_m * distance_m);
}

/// Share of a sample of density `own` where another strategy draws it with `other` (Veach 1997,
/// Section 9.2.4: power heuristic, exponent 2). Both 1/sr.
[[nodiscard]] inline float power_share(float own, float other) {
    const float ratio = other / own;
    return 1.0F / (1.0F + ratio * ratio);
}

class Lights {
public:
    /// Everything outlives this.
    /// `sun`: one more light, or null.
    Lights(const scene::Scene& scene, const Textures& textures, const scene::Light* sun = nullptr);
    /// Listed lights, and one for all meshes that emit.
    [[nodiscard]] std::size_t count() const { return lights_.size() + (emitters_.empty() ? 0 : 1); }

    /// Whether a light has a size: a listed one, or the meshes that emit.
    [[nodiscard]] bool has_size(std::size_t light) const;

    /// A light to draw from; the last of count() is the meshes that emit.
    struct Choice {
        std::size_t light = 0;
        float probability = 0.0F;
        float total_weight = 0.0F;
    };
    /// In place of Choice::total_weight where every light is drawn from, each with probability 1.
    static constexpr float every_light = -1.0F;
    enum class Among : std::uint8_t { all, sized };
    [[nodiscard]] std::size_t count(Among among) const {
        return among == Among::sized ? sized_count_ : count();
    }
    /// One light, by what it can do at `position_m` at most.
    [[nodiscard]] Choice choose(const math::Vec3& position_m, float u,
                                Among among = Among::all) const;
    [[nodiscard]] LightSample sample(const Choice& choice, const math::Vec3& position_m,
                                     math::Vec2 u, float pick) const;

    /// Lux of the listed lights on a surface of that unit normal, if nothing stood in the way;
    /// those with a size by 64 places each.
    [[nodiscard]] math::Vec3 irradiance(const math::Vec3& position_m,
                                        const math::Vec3& normal) const;

    /// How a ray's direction was drawn at its origin, where lights were drawn from too.
    struct DrawnWay {
        float pdf = 0.0F;           ///< 1/sr
        bool is_mirror = false;     ///< nothing else could have drawn it
        Among among = Among::all;   ///< which lights were
        float total_weight = 0.0F;  ///< Choice::total_weight of them

        /// A mirror's has no bound: what the light draws itself counts nothing beside it.
        [[nodiscard]] float density() const { return is_mirror ? 1e20F : pdf; }
    };
    /// Radiance of the lights that a ray meets between `near_m` and `far_m`: those with a size, all
    /// of them, as only shapes that end the ray hide others, and those beyond it that cast no
    /// shadow; and, where they were drawn from, directional lights that fill an angle. Each is
    /// weighted against sample(), which would have drawn that direction too, by the power
    /// heuristic. `extinction_per_m`: on the way from `near_m` on. `at_end`: what the ray ends at,
    /// or null; where it is a light's own shape, that light is met for sure.
    [[nodiscard]] math::Vec3 met(const Ray& ray, const DrawnWay& drawn,
                                 const math::Vec3& extinction_per_m = math::Vec3(0.0F),
                                 const Hit* at_end = nullptr) const;
    /// The weight, likewise, of a mesh that emits, met by a ray at `hit`, which is at its far_m.
    [[nodiscard]] float mesh_share(const Hit& hit, const Ray& ray, const DrawnWay& drawn) const;

private:
    struct Emitter {
        std::uint32_t instance;
        std::uint32_t triangle;
        float area_m2;
    };
    void add_emitters(const scene::Scene& scene, std::uint32_t instance);
    [[nodiscard]] float weight(const scene::Light& light, const math::Vec3& position_m) const;
    /// Probability of drawing from a light of this weight.
    [[nodiscard]] static float chance(float weight, float total_weight) {
        return total_weight == every_light ? 1.0F
               : total_weight > 0.0F       ? weight / total_weight
                                           : 0.0F;
    }
    [[nodiscard]] float mesh_weight(const math::Vec3& position_m) const;
    [[nodiscard]] LightSample sample_mesh(const math::Vec3& position_m, math::Vec2 u,
                                          float pick) const;

    const scene::Scene* scene_;
    const Textures* textures_;
    std::vector<scene::Light> lights_;    ///< the scene's, without those that stand in for a mesh
    std::vector<scene::LightAxes> axes_;  ///< by light
    std::vector<std::size_t> places_;     ///< in the scene, by light
    std::size_t sized_count_ = 0;
    bool has_suns_ = false;  ///< directional lights that fill an angle
    std::vector<Emitter> emitters_;
    std::vector<std::size_t>
        first_emitter_;  ///< by instance; a mesh's emitters are in the order of its triangles
    Distribution emitter_shares_;
    math::Vec3 emitters_center_m_{0.0F};
    float emitters_radius2_m2_ = 0.0F;
    float emitted_ = 0.0F;  ///< sum of nit times square metres
};

}  // namespace facet::trace
