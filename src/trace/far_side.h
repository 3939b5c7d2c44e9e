// Light through a surface: what it gets from its far side, and, within a volume, all that its
// boundary does. glsl/brdf/model/transmission.glsl.
// SPDX-License-Identifier: MIT
#pragma once

#include "brdf/terms.h"
#include "math/vector.h"
#include "trace/surface.h"

namespace facet::trace {

/// A lobe that reflects, as what is thin sends it on to its far side.
struct ThinLobe {
    float roughness = 1.0F;
    float alpha = 1.0F;
    float albedo = 1.0F;  ///< seen as it is, without Fresnel
};

/// Directions are in the frame of the shading normal, the viewer's z is above 0. Lights are asked
/// for below, and within a volume on either side.
class FarSide {
public:
    /// `alpha`: of the boundary of a volume; `thin`: in its place without one. `left`: what the
    /// surface's other lobes leave of white light.
    FarSide(const Lobes& terms, const Surface& surface, float alpha, const ThinLobe& thin,
            const math::Vec3& to_eye, const math::Vec3& left);

    /// Seen from within a volume, or from a denser one around it, nothing else of the surface is:
    /// its own reflection, which may be total, is in this.
    [[nodiscard]] bool is_inside() const { return is_inside_; }
    /// Light goes through in one direction alone.
    [[nodiscard]] bool is_smooth() const { return is_smooth_; }
    /// Of light from everywhere, by channel.
    [[nodiscard]] math::Vec3 weight() const { return through_ + diffuse_; }

    struct Value {
        math::Vec3 diffuse{0.0F};  ///< f |cos|, 1/sr
        math::Vec3 specular{0.0F};
        float pdf = 0.0F;  ///< of sample()
    };
    [[nodiscard]] Value value(const math::Vec3& to_light) const;

    struct Sample {
        math::Vec3 to_light{0.0F};  ///< 0 where none was found
        math::Vec3 share{0.0F};     ///< of a mirror: over its probability; else value() has it
        bool is_mirror = false;
        bool is_straight = false;
    };
    [[nodiscard]] Sample sample(math::Vec2 u, float lobe) const;

private:
    [[nodiscard]] math::Vec3 reflected(const math::Vec3& h) const;
    [[nodiscard]] float reflectance(float v_dot_h) const;
    /// Of directions that facets reflect within a volume, and let through, 1/sr.
    [[nodiscard]] float density_reflected(const math::Vec3& to_light) const;
    [[nodiscard]] float density_through(const math::Vec3& to_light) const;

    Lobes terms_;
    math::Vec3 to_eye_;
    float alpha_;
    bool is_inside_;
    bool has_volume_;
    bool is_smooth_;
    float eta_;                 ///< index of the far side over the near one's
    math::Vec3 through_{0.0F};  ///< factor on what goes through; within, of what is not reflected
    math::Vec3 diffuse_{0.0F};  ///< factor on the diffuse light of the far side
    math::Vec3 diffuse_near_{0.0F};  ///< likewise within a volume, of that side
    float diffuse_share_ = 0.0F;     ///< of the samples
    float near_share_ = 0.0F;
    ThinLobe thin_;
};

}  // namespace facet::trace
