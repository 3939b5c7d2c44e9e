// What a ray finds where it meets a triangle: place, normals, and the material's numbers there.
// SPDX-License-Identifier: MIT
#pragma once

#include "brdf/terms.h"
#include "scene/scene.h"
#include "trace/geometry.h"
#include "trace/textures.h"

#include <vector>

namespace facet::trace {

using Lobes = brdf::Terms<float>;

/// The numbers that the G-buffer holds, at one point. World space.
struct Surface {
    math::Vec3 position_m{0.0F};
    math::Vec3 outside_m{
        0.0F};  ///< beside the position, on the viewer's side, free of its own triangle
    math::Vec3 beyond_m{0.0F};     ///< likewise on the far side
    math::Vec3 face_normal{0.0F};  ///< unit, of the triangle, on the side of the viewer
    math::Vec3 normal{0.0F};       ///< unit, shading, turned with the face
    math::Vec3 base_color{1.0F};
    float opacity = 1.0F;
    float metallic = 0.0F;
    float roughness = 1.0F;  ///< perceptual
    float bumps = 0.0F;      ///< of the normal map's level (image/normal_mips.h): in the roughness
    /// Without them, as both sides of a thin wall have the same and light through it is not turned.
    float thin_roughness = 1.0F;
    math::Vec3 dielectric_f0{Lobes::DIELECTRIC_F0};
    float specular = 1.0F;  ///< strength of the dielectric's reflection
    float coat = 0.0F;      ///< strength of the lacquer over it; without it the two below are unset
    float coat_roughness = 0.0F;
    math::Vec3 coat_normal{0.0F};
    math::Vec3 sheen_color{0.0F};  ///< of the fibres over it; without them the one below is unset
    float sheen_roughness = 0.0F;
    float transmission = 0.0F;  ///< share of the light below the reflection that goes on through
    bool has_volume = false;    ///< which bends that light, by
    float ior = 1.5F;           ///< from what is around, of this index,
    float ior_around = 1.0F;    ///< and takes of it:
    math::Vec3 extinction_per_m{0.0F};
    math::Vec3 scattered{0.0F};       ///< share of that which is scattered, not absorbed
    float scatter_anisotropy = 0.0F;  ///< mean cosine
    float dispersion = 0.0F;
    float diffuse_transmission = 0.0F;  ///< share of the diffuse light that leaves on the far side
    math::Vec3 diffuse_transmission_color{1.0F};
    float anisotropy = 0.0F;   ///< strength; the direction is unset without it
    math::Vec3 tangent{0.0F};  ///< unit, square to `normal`: highlights are long along it
    float film = 0.0F;         ///< strength of a thin film; without it the two below are unset
    float film_ior = 1.0F;
    float film_nm = 0.0F;
    bool has_ramp = false;       ///< its reflectance, as the viewer sees it, is from a table:
    math::Vec3 reflected{0.0F};  ///< this
    float ao = 1.0F;             ///< of the occlusion map; for AOVs, as rays find what is occluded
    math::Vec3 emissive_nit{0.0F};
    bool front = true;
    bool unlit = false;
    std::uint32_t instance = 0;
    std::uint32_t material = 0;
};

/// What of an instance does not change from hit to hit.
struct InstanceFrame {
    math::Mat3 normal_from_object{1.0F};  ///< cofactors: right for any scale
    float rounding_m = 0.0F;              ///< bound on the error of a position, along any axis
};
[[nodiscard]] std::vector<InstanceFrame> instance_frames(const scene::Scene& scene);

/// `cone_m`: width of what the ray stands for where it hits; chooses the mip level (Akenine-Moller
/// et al. 2019, "Texture Level of Detail Strategies for Real-Time Ray Tracing", Eq. 30).
[[nodiscard]] Surface surface_at(const scene::Scene& scene,
                                 const std::vector<InstanceFrame>& frames, const Textures& textures,
                                 const Hit& hit, const math::Vec3& direction, float cone_m);

/// Lobes that are narrower are mirrors: float's n.h resolves no half vector within them (1 - n.h
/// comes in steps of 6e-8, and D turns within alpha^2 / 2).
inline constexpr float mirror_alpha_max = 1e-3F;

/// Width of its narrowest lobe.
[[nodiscard]] inline float narrowest_alpha(const Surface& surface) {
    const float coat = surface.coat > 0.0F ? surface.coat_roughness : 1.0F;
    const float roughness = surface.roughness < coat ? surface.roughness : coat;
    return roughness * roughness;
}

/// Whether its coat shows a picture where the base shows none: below `mirrored_alpha` lobes are
/// drawn at every sample of a frame, others once for all.
[[nodiscard]] inline bool has_coat_apart(const Surface& surface, float mirrored_alpha) {
    return surface.coat > 0.0F &&
           surface.coat_roughness * surface.coat_roughness < mirrored_alpha &&
           surface.roughness * surface.roughness >= mirrored_alpha;
}

/// One pixel of a picture as a rasteriser stored it: which triangle is seen, and the numbers that
/// textures gave there.
struct SeenPixel {
    static constexpr std::uint32_t nothing = ~0U;
    std::uint32_t instance = nothing;
    std::uint32_t triangle = 0;
    math::Vec3 normal{0.0F};  ///< unit, shading, on the side of the viewer
    math::Vec3 base_color{0.0F};
    float metallic = 0.0F;
    float roughness = 1.0F;
    math::Vec3 dielectric_f0{Lobes::DIELECTRIC_F0};
    float specular = 1.0F;
};
/// The surface of such a pixel where a ray from the eye meets its triangle's plane; edges are
/// drawn a little beyond it. Its layers, which no target holds, are of the finest level.
[[nodiscard]] Surface seen_surface(const scene::Scene& scene,
                                   const std::vector<InstanceFrame>& frames,
                                   const Textures& textures, const SeenPixel& pixel,
                                   const Ray& from_eye);

/// Share of light that the surface takes there, from the finest level: 1 where it is opaque, 0 in a
/// mask's hole, a blend's opacity.
[[nodiscard]] float coverage_at(const scene::Scene& scene, const Textures& textures,
                                const Hit& hit);
/// Share of light that goes straight on through a thin and smooth surface there, from the finest
/// level, for a ray of that unit direction; 0 of all others.
[[nodiscard]] math::Vec3 straight_share(const scene::Scene& scene, const Textures& textures,
                                        const Hit& hit, const math::Vec3& direction);
/// Radiance emitted there, from the finest level, nit.
[[nodiscard]] math::Vec3 emission_at(const scene::Scene& scene, const Textures& textures,
                                     const Hit& hit);
/// The same without its texture.
[[nodiscard]] math::Vec3 emission_factor(const scene::Material& material);
[[nodiscard]] math::Vec3 position_at(const scene::Scene& scene, const Hit& hit);

}  // namespace facet::trace
