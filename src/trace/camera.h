// Rays of a picture's pixels.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"
#include "scene/lens.h"
#include "scene/scene.h"
#include "trace/geometry.h"

namespace facet::trace {

/// What of the light that a pixel gets a ray stands for.
struct RayChoice {
    math::Vec2 lens_m{0.0F};  ///< place on the lens that it comes through
    float time = 0.5F;        ///< [0, 1] from the opening of the shutter to its closing
    int channel = 1;          ///< 0 red, 1 green, 2 blue: lenses may bend them apart
};

class CameraRays {
public:
    CameraRays(const scene::Camera& camera, math::Extent picture);

    /// `at_px` from the top left of the whole picture. The ray begins at the near plane, as the
    /// rasteriser clips.
    [[nodiscard]] Ray ray(math::Vec2 at_px, const RayChoice& choice = {}) const;
    /// Share of its light that the lens lets through.
    [[nodiscard]] float vignetting(math::Vec2 at_px, const RayChoice& choice) const;
    [[nodiscard]] bool vignettes() const { return camera_.barrel.rim_m > 0.0F; }
    [[nodiscard]] bool has_lens() const { return camera_.lens_radius_m > 0.0F; }
    [[nodiscard]] bool moves() const { return moves_; }
    /// Colours take ways of their own.
    [[nodiscard]] bool is_chromatic() const { return camera_.aberration != 0.0F; }
    [[nodiscard]] math::Vec2 place_on_lens(math::Vec2 u) const {
        return scene::place_on_lens(camera_, u);
    }
    /// Unit; where the camera looks.
    [[nodiscard]] math::Vec3 forward() const { return -math::Vec3(camera_.world_from_view[2]); }
    /// Width of a pixel: at the eye, metres, and its growth per metre.
    [[nodiscard]] float cone_at_eye_m() const { return is_orthographic() ? pixel_ : 0.0F; }
    [[nodiscard]] float cone_spread() const { return is_orthographic() ? 0.0F : pixel_; }

private:
    [[nodiscard]] bool is_orthographic() const {
        return camera_.projection == scene::Projection::orthographic;
    }
    /// On the plane at distance 1.
    [[nodiscard]] math::Vec2 aside(math::Vec2 at_px, int channel) const;
    [[nodiscard]] Ray panorama_ray(math::Vec2 at_px) const;

    scene::Camera camera_;
    math::Extent picture_;
    math::Vec2 scale_{1.0F};
    float pixel_ = 0.0F;
    bool moves_;
    bool bends_;
};

}  // namespace facet::trace
