// Rays of a picture's pixels.
// SPDX-License-Identifier: MIT
#include "trace/camera.h"

#include "scene/camera_spec.h"
#include "scene/motion.h"
#include "scene/projection.h"

#include <cmath>

namespace facet::trace {

using math::Vec2;
using math::Vec3;

CameraRays::CameraRays(const scene::Camera& camera, math::Extent picture)
    : camera_(camera),
      picture_(picture),
      moves_(scene::moves(camera)),
      bends_(scene::bends(camera)) {
    if (camera.projection == scene::Projection::panorama) {
        pixel_ = math::pi / static_cast<float>(picture.height);
        return;
    }
    const math::Mat4 clip = scene::clip_from_view(camera, picture, Vec2(0.0F));
    scale_ = {1.0F / clip[0][0], 1.0F / clip[1][1]};
    pixel_ = 2.0F * scale_.y / static_cast<float>(picture.height);
}

Vec2 CameraRays::aside(Vec2 at_px, int channel) const {
    if (bends_) at_px = scene::source_of(camera_, picture_, at_px, channel);
    const Vec2 size(picture_.width, picture_.height);
    const Vec2 ndc(2.0F * at_px.x / size.x - 1.0F, 1.0F - 2.0F * at_px.y / size.y);
    return ndc * scale_;
}

Ray CameraRays::panorama_ray(Vec2 at_px) const {
    const Vec2 size(picture_.width, picture_.height);
    Ray out;
    out.origin = Vec3(camera_.world_from_view[3]);
    out.direction = math::Mat3(camera_.world_from_view) * scene::panorama_direction(at_px / size);
    out.near_m = camera_.near_m;
    if (camera_.far_m > 0.0F) out.far_m = camera_.far_m;
    return out;
}

Ray CameraRays::ray(Vec2 at_px, const RayChoice& choice) const {
    if (camera_.projection == scene::Projection::panorama) return panorama_ray(at_px);
    const math::Mat4 world_from_view =
        moves_ ? scene::camera_at(camera_, choice.time).world_from_view : camera_.world_from_view;
    const Vec3 off(aside(at_px, choice.channel), is_orthographic() ? 0.0F : -1.0F);
    const math::Mat3 rotation(world_from_view);
    const Vec3 eye(world_from_view[3]);
    Vec3 way = is_orthographic() ? -rotation[2] : rotation * off;
    Ray out;
    out.origin = is_orthographic() ? eye + rotation * off : eye;
    if (has_lens()) {
        const Vec3 place(choice.lens_m, 0.0F);
        way = rotation * (off - place / camera_.focus_m);
        out.origin = eye + rotation * place;
    }
    const float length = math::length(way);
    out.direction = way / length;
    out.near_m = camera_.near_m * length;
    if (camera_.far_m > 0.0F) out.far_m = camera_.far_m * length;
    return out;
}

float CameraRays::vignetting(Vec2 at_px, const RayChoice& choice) const {
    return scene::vignetting(camera_.barrel, aside(at_px, choice.channel), choice.lens_m);
}

}  // namespace facet::trace
