// How one surface point scatters light: the shared BRDF text in the point's own frame.
// SPDX-License-Identifier: MIT
#pragma once

#include "brdf/albedo.h"
#include "brdf/terms.h"
#include "math/vector.h"
#include "trace/surface.h"

namespace facet::trace {

/// As in lib/shading_bounds.glsl: below this cosine the surface is seen edge on.
inline constexpr float n_dot_v_min = 1e-3F;

/// The BRDF of a picture: the terms chosen, and the table that the rasteriser looks up too.
struct Model {
    explicit Model(const tables::BrdfChoice& choice);

    /// Texel of the table at one direction, bilinear as GL filters it.
    [[nodiscard]] Lobes::real4 albedo(float n_dot_v, float roughness) const;

    Lobes lights;
    Lobes environment;
    brdf::AlbedoTable table;
    bool one_masking = true;  ///< lights and environment are masked alike
    bool needs_e_l = false;
};

/// f cos(theta) of the whole BRDF, 1/sr, for light of either kind; and the density of sample()
/// there.
struct Scattered {
    math::Vec3 of_light{0.0F};
    math::Vec3 of_environment{0.0F};
    float pdf = 0.0F;
};

class Bsdf {
public:
    /// Which lobes sample() draws from; `white`: of a Lambert surface of albedo 1, whatever the
    /// surface's own.
    enum class Draws : std::uint8_t { both, specular, white };
    /// `to_eye` is unit. `model` outlives this.
    Bsdf(const Model& model, const Surface& surface, const math::Vec3& to_eye,
         Draws draws = Draws::both);

    /// For a unit direction to the light. Zero below the surface. A mirror's lobe is not in it.
    [[nodiscard]] Scattered evaluate(const math::Vec3& to_light) const;

    /// Of the specular lobe alone, and of the environment alone; the density is the whole one.
    [[nodiscard]] Scattered evaluate_specular(const math::Vec3& to_light) const;

    /// What the diffuse lobe has of evaluate()'s values, by channel, [0, 1].
    struct DiffuseShares {
        math::Vec3 of_light{0.0F};
        math::Vec3 of_environment{0.0F};
    };
    [[nodiscard]] DiffuseShares diffuse_shares(const math::Vec3& to_light) const;

    /// Factors on irradiance / pi and on the mean over the specular lobe of what arrives.
    [[nodiscard]] Lobes::BrdfValue environment_weight() const;

    struct Sample {
        math::Vec3 direction{0.0F};  ///< unit, to the light
        Scattered scattered;  ///< of a mirror: the share reflected over its probability, with pdf 1
        bool is_mirror = false;
        bool is_valid = false;
    };
    [[nodiscard]] Sample sample(math::Vec2 u, float lobe) const;

private:
    struct Cosines {
        float n_dot_l = 0.0F;
        float n_dot_h = 0.0F;
        float v_dot_h = 0.0F;
    };
    /// False below the surface.
    [[nodiscard]] bool cosines(const math::Vec3& to_light, Cosines& out) const;
    [[nodiscard]] Lobes::BrdfValue values(Lobes terms, const Cosines& at) const;

    const Model* model_;
    Lobes::BrdfView view_;
    Lobes::BrdfSampler sampler_;
    math::Vec3 to_eye_;
    math::Vec3 face_normal_;
    math::Vec3 x_, y_, n_;
    bool is_mirror_;
    bool is_white_;
};

}  // namespace facet::trace
