// How one surface point scatters light: the shared BRDF text in the point's own frame.
// SPDX-License-Identifier: MIT
#pragma once

#include "brdf/albedo.h"
#include "brdf/terms.h"
#include "math/vector.h"
#include "trace/far_side.h"
#include "trace/surface.h"

#include <optional>

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

/// Share of a surface's own light that passes its coat to the viewer.
[[nodiscard]] float through_coat(const Model& model, const Surface& surface,
                                 const math::Vec3& to_eye);

/// A unit vector and two at right angles to it.
struct LobeFrame {
    math::Vec3 x{0.0F}, y{0.0F}, z{0.0F};
    LobeFrame() = default;
    explicit LobeFrame(const math::Vec3& axis);
    /// `along`: unit, square to the axis.
    LobeFrame(const math::Vec3& axis, const math::Vec3& along);
    [[nodiscard]] math::Vec3 local(const math::Vec3& world) const {
        return {math::dot(x, world), math::dot(y, world), math::dot(z, world)};
    }
    [[nodiscard]] math::Vec3 world(const math::Vec3& local) const {
        return math::normalize(x * local.x + y * local.y + z * local.z);
    }
};

class Bsdf {
public:
    /// Which lobes sample() draws from. `both`: those that reflect, and no others are in values;
    /// `coat`, `far`: that one, and what is of the surface's far side, are alone in values and
    /// weights too; `white`: of a Lambert surface of albedo 1, whatever the surface's own.
    enum class Draws : std::uint8_t { all, both, specular, coat, far, white };
    /// `to_eye` is unit. `model` outlives this.
    Bsdf(const Model& model, const Surface& surface, const math::Vec3& to_eye,
         Draws draws = Draws::all);

    /// For a unit direction to the light, on either side. A mirror's lobe, and that of a smooth
    /// surface that light goes through, are not in it.
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

    /// Of light from everywhere on the far side; 0 without FarSide.
    [[nodiscard]] math::Vec3 far_weight() const { return far_ ? far_->weight() : math::Vec3(0.0F); }

    /// Part of the diffuse weight, in luminance, that is of fibres.
    [[nodiscard]] float sheen_share() const;

    struct Sample {
        math::Vec3 direction{0.0F};  ///< unit, to the light
        Scattered scattered;  ///< of a mirror: the share reflected over its probability, with pdf 1
        bool is_mirror = false;
        bool is_straight = false;  ///< a mirror's share too, of light from right behind
        bool is_valid = false;
    };
    [[nodiscard]] Sample sample(math::Vec2 u, float lobe) const;

private:
    struct Cosines {
        float n_dot_l = 0.0F;
        float n_dot_h = 0.0F;
        float v_dot_h = 0.0F;
        float coat_n_dot_l = 0.0F;
        float coat_n_dot_h = 0.0F;
        math::Vec3 local_l{0.0F};  ///< in the frame of two widths, where the lobe has them
        math::Vec3 local_h{0.0F};
    };
    /// False below the surface.
    [[nodiscard]] bool cosines(const math::Vec3& to_light, Cosines& out) const;
    /// Of all layers; a mirror's lobe is not in it.
    [[nodiscard]] Lobes::BrdfValue values(Lobes terms, const Cosines& at) const;
    [[nodiscard]] float pdf(const Cosines& at) const;
    /// Of the base's lobes alone.
    [[nodiscard]] float base_pdf(const Cosines& at) const;
    [[nodiscard]] math::Vec3 sample_base(math::Vec2 u, float lobe) const;
    [[nodiscard]] Sample sample_far(math::Vec2 u, float lobe) const;
    [[nodiscard]] FarSide::Value of_far(const math::Vec3& to_light) const;
    /// Whether FarSide tells of light from there.
    [[nodiscard]] bool is_far(const math::Vec3& to_light) const {
        return far_ && (far_->is_inside() || math::dot(face_normal_, to_light) <= 0.0F);
    }
    void set_far(const Surface& surface, Draws draws);
    void set_sheen(const Surface& surface);
    void set_coat(const Surface& surface, Draws draws);
    /// Weights of the environment, but the coat's own.
    [[nodiscard]] Lobes::BrdfValue weight_below() const;
    /// Of the light, by coat and fibres, for the base.
    [[nodiscard]] float left_by_layers() const {
        return (is_coated_ ? 1.0F - coat_.albedo : 1.0F) * (has_sheen_ ? sheen_.left : 1.0F);
    }
    /// No lobe of sample() has a width.
    [[nodiscard]] bool has_mirrors_alone() const {
        return (is_mirror_ || is_coat_alone_) && (!is_coated_ || is_coat_mirror_);
    }
    [[nodiscard]] Sample mirrored(const math::Vec3& normal, const math::Vec3& share) const;

    const Model* model_;
    Lobes::BrdfView view_;
    Lobes::BrdfSampler sampler_;
    math::Vec3 to_eye_;
    math::Vec3 face_normal_;
    LobeFrame frame_;
    bool is_mirror_;
    bool is_white_;
    bool is_anisotropic_ = false;
    math::Vec2 alpha_xy_{1.0F};   ///< along frame_.x and frame_.y
    math::Vec3 local_eye_{0.0F};  ///< in frame_
    std::optional<FarSide> far_;
    bool is_far_alone_ = false;
    float far_share_ = 0.0F;  ///< of the samples
    bool has_sheen_ = false;
    Lobes::BrdfSheen sheen_{};
    bool is_coated_ = false;
    bool is_coat_mirror_ = false;
    bool is_coat_alone_ = false;
    Lobes::BrdfCoat coat_{};
    LobeFrame coat_frame_;
    math::Vec3 coat_to_eye_{0.0F};  ///< in that frame
    float coat_share_ = 0.0F;       ///< of the samples
};

}  // namespace facet::trace
