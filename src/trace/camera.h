// Rays of a picture's pixels.
// SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"
#include "scene/camera_spec.h"
#include "scene/lens.h"
#include "scene/scene.h"
#include "trace/geometry.h"

#include <cmath>

namespace facet::trace {

class CameraRays {
public:
    CameraRays(const scene::Camera& camera, math::Extent picture)
        : camera_(camera),
          size_(picture.width, picture.height),
          orthographic_(camera.projection == scene::Projection::orthographic) {
        const math::Mat4 clip = scene::clip_from_view(camera, picture, math::Vec2(0.0F));
        scale_ = {1.0F / clip[0][0], 1.0F / clip[1][1]};
        pixel_ = 2.0F * scale_.y / size_.y;
    }

    /// `at_px` from the top left of the whole picture. The ray begins at the near plane, as the
    /// rasteriser clips.
    /// `lens_m`: the place on the lens that it comes through.
    [[nodiscard]] Ray ray(math::Vec2 at_px, math::Vec2 lens_m = math::Vec2(0.0F)) const {
        const math::Vec2 ndc(2.0F * at_px.x / size_.x - 1.0F, 1.0F - 2.0F * at_px.y / size_.y);
        const math::Vec3 aside(ndc.x * scale_.x, ndc.y * scale_.y, orthographic_ ? 0.0F : -1.0F);
        const math::Mat3 rotation(camera_.world_from_view);
        const math::Vec3 eye(camera_.world_from_view[3]);
        math::Vec3 way = orthographic_ ? -rotation[2] : rotation * aside;
        Ray out;
        out.origin = orthographic_ ? eye + rotation * aside : eye;
        if (has_lens()) {
            const math::Vec3 place(lens_m, 0.0F);
            way = rotation * (aside - place / camera_.focus_m);
            out.origin = eye + rotation * place;
        }
        const float length = math::length(way);
        out.direction = way / length;
        out.near_m = camera_.near_m * length;
        if (camera_.far_m > 0.0F) out.far_m = camera_.far_m * length;
        return out;
    }
    [[nodiscard]] bool has_lens() const { return camera_.lens_radius_m > 0.0F; }
    [[nodiscard]] math::Vec2 place_on_lens(math::Vec2 u) const {
        return scene::place_on_lens(camera_, u);
    }
    /// Unit; where the camera looks.
    [[nodiscard]] math::Vec3 forward() const { return -math::Vec3(camera_.world_from_view[2]); }
    /// Width of a pixel: at the eye, metres, and its growth per metre.
    [[nodiscard]] float cone_at_eye_m() const { return orthographic_ ? pixel_ : 0.0F; }
    [[nodiscard]] float cone_spread() const { return orthographic_ ? 0.0F : pixel_; }

private:
    scene::Camera camera_;
    math::Vec2 size_;
    math::Vec2 scale_{1.0F};
    float pixel_ = 0.0F;
    bool orthographic_;
};

}  // namespace facet::trace
