// One view of the scene.
// SPDX-License-Identifier: MIT
#include "frame/view.h"

#include "scene/camera_spec.h"

namespace facet::frame {
namespace {

/// Enlarges `region` of the picture to the whole of clip space.
math::Mat4 region_from_picture(math::Extent picture, const Region& region) {
    const math::Vec2 whole(picture.width, picture.height);
    const math::Vec2 part(region.size.width, region.size.height);
    const math::Vec2 corner(region.x, region.y);
    const math::Vec2 scale = whole / part;
    const math::Vec2 center = (corner + part * 0.5F) / whole * 2.0F - 1.0F;  // y down
    math::Mat4 m(1.0F);
    m[0][0] = scale.x;
    m[1][1] = scale.y;
    m[3][0] = -center.x * scale.x;
    m[3][1] = center.y * scale.y;
    return m;
}

/// The first `bits` bits of `x` in reverse, as a fraction (van der Corput's sequence in base 2).
float radical_inverse(std::uint32_t x) {
    float result = 0.0F;
    for (float digit = 0.5F; x > 0; x >>= 1U, digit *= 0.5F)
        if ((x & 1U) != 0) result += digit;
    return result;
}

}  // namespace

shared::View view_block(const scene::Camera& camera, math::Extent picture, const Region& region,
                        math::Vec2 jitter_px) {
    const math::Mat4 clip_from_view =
        region_from_picture(picture, region) * scene::clip_from_view(camera, picture, jitter_px);
    shared::View view{};
    const float pixel = 2.0F / scene::clip_from_view(camera, picture, math::Vec2(0.0F))[1][1] /
                        static_cast<float>(picture.height);
    const bool is_perspective = camera.projection == scene::Projection::perspective;
    view.pixel = {is_perspective ? 0.0F : pixel, is_perspective ? pixel : 0.0F, jitter_px.x,
                  -jitter_px.y};
    view.clip_from_world = clip_from_view * scene::view_from_world(camera);
    view.world_from_clip = math::inverse(view.clip_from_world);
    const math::Mat4& world_from_view = camera.world_from_view;
    view.eye_m = math::Vec4(math::Vec3(world_from_view[3]), is_perspective ? 1.0F : 0.0F);
    view.forward = math::Vec4(-math::normalize(math::Vec3(world_from_view[2])), 0.0F);
    const auto width = static_cast<float>(region.size.width);
    const auto height = static_cast<float>(region.size.height);
    view.size_px = {width, height, 1.0F / width, 1.0F / height};
    return view;
}

math::Vec2 jitter_px(std::uint32_t index, std::uint32_t count) {
    const float half = 0.5F / static_cast<float>(count);
    const float x = (static_cast<float>(index) + 0.5F) / static_cast<float>(count) - 0.5F;
    // Exact N-rooks where count is a power of two; elsewhere van der Corput's points are as good.
    return {x, count == 1 ? 0.0F : radical_inverse(index) + half - 0.5F};
}

}  // namespace facet::frame
