// One view of the scene.
// SPDX-License-Identifier: MIT
#include "frame/view.h"

#include "scene/camera_spec.h"
#include "scene/lens.h"
#include "scene/motion.h"

#include <numeric>

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

/// The digits of `x` in a base in reverse, as a fraction (Halton 1960; van der Corput in base 2).
float radical_inverse(std::uint32_t x, std::uint32_t base = 2) {
    float result = 0.0F;
    const float part = 1.0F / static_cast<float>(base);
    for (float digit = part; x > 0; x /= base, digit *= part)
        result += digit * static_cast<float>(x % base);
    return result;
}

/// The first place is the middle of the lens, the others lie evenly around it (Halton 1960, shifted
/// by a half: Cranley and Patterson 1976).
math::Vec2 lens_place(const scene::Camera& camera, std::uint32_t index, std::uint32_t count) {
    if (camera.lens_radius_m <= 0.0F || count == 1) return math::Vec2(0.0F);
    const math::Vec2 u(radical_inverse(index, 3) + 0.5F, radical_inverse(index, 5) + 0.5F);
    return scene::place_on_lens(camera, u - glm::floor(u));
}

/// What vignetting is worked out from.
void set_lens(const scene::Camera& camera, math::Extent picture, const Region& region,
              math::Vec2 lens_m, shared::View& view) {
    if (camera.barrel.rim_m <= 0.0F) return;
    view.lens = {lens_m, camera.barrel.rim_m, camera.barrel.shift_m};
    const math::Mat4 clip = scene::clip_from_view(camera, picture, math::Vec2(0.0F));
    const math::Vec2 per_px(2.0F / (static_cast<float>(picture.width) * clip[0][0]),
                            2.0F / (static_cast<float>(picture.height) * clip[1][1]));
    const math::Vec2 corner(region.x, picture.height - region.y - region.size.height);
    const math::Vec2 off = (corner - math::Vec2(picture.width, picture.height) * 0.5F) * per_px;
    view.tangents = {per_px, off};
}

}  // namespace

shared::View view_block(const scene::Camera& camera, math::Extent picture, const Region& region,
                        math::Vec2 jitter_px, math::Vec2 lens_m, const scene::Camera* moved) {
    const scene::Camera& eye = moved == nullptr ? camera : *moved;
    const math::Mat4 clip_from_view =
        region_from_picture(picture, region) * scene::clip_from_view(camera, picture, jitter_px);
    shared::View view{};
    const float pixel = 2.0F / scene::clip_from_view(camera, picture, math::Vec2(0.0F))[1][1] /
                        static_cast<float>(picture.height);
    const bool is_perspective = camera.projection == scene::Projection::perspective;
    view.pixel = {is_perspective ? 0.0F : pixel, is_perspective ? pixel : 0.0F, 0.0F, 0.0F};
    // From another place on the lens, what lies at the depth in focus stays where it is.
    math::Mat4 from_lens(1.0F);
    from_lens[2] = {-lens_m / camera.focus_m, 1.0F, 0.0F};
    from_lens[3] = {-lens_m, 0.0F, 1.0F};
    view.clip_from_world = clip_from_view * from_lens * scene::view_from_world(eye);
    view.middle_from_world = region_from_picture(picture, region) *
                             scene::clip_from_view(camera, picture, math::Vec2(0.0F)) *
                             scene::view_from_world(camera);
    view.world_from_clip = math::inverse(view.clip_from_world);
    const math::Mat4& world_from_view = eye.world_from_view;
    view.eye_m = math::Vec4(math::Vec3(world_from_view * math::Vec4(lens_m, 0.0F, 1.0F)),
                            is_perspective ? 1.0F : 0.0F);
    view.forward = math::Vec4(-math::normalize(math::Vec3(world_from_view[2])), 0.0F);
    const auto width = static_cast<float>(region.size.width);
    const auto height = static_cast<float>(region.size.height);
    view.size_px = {width, height, 1.0F / width, 1.0F / height};
    set_lens(camera, picture, region, lens_m, view);
    return view;
}

shared::View sample_view(const scene::Camera& camera, math::Extent picture, const Region& region,
                         std::uint32_t index, std::uint32_t count) {
    const math::Vec2 lens_m = lens_place(camera, index, count);
    if (!scene::moves(camera))
        return view_block(camera, picture, region, jitter_px(index, count), lens_m);
    const scene::Camera moved = scene::camera_at(camera, sample_time(index, count));
    return view_block(camera, picture, region, jitter_px(index, count), lens_m, &moved);
}

float vignetting(const shared::View& view, std::uint32_t x, std::uint32_t y) {
    const math::Vec2 at(static_cast<float>(x) + 0.5F,
                        view.size_px.y - static_cast<float>(y) - 0.5F);
    const math::Vec2 tangent = math::Vec2(view.tangents.z, view.tangents.w) +
                               math::Vec2(view.tangents.x, view.tangents.y) * at;
    return scene::vignetting({view.lens.z, view.lens.w}, tangent, {view.lens.x, view.lens.y});
}

float sample_time(std::uint32_t index, std::uint32_t count) {
    // A lattice's second dimension (Korobov 1959), so that neither the places in the pixel nor
    // those on the lens go with time: a number near the golden section of the count that has no
    // factor in common with it, or times would repeat.
    auto golden = static_cast<std::uint64_t>(0.6180339887 * count) | 1U;
    while (std::gcd(golden, std::uint64_t{count}) > 1) golden += 2;
    const std::uint64_t place = count < 2 ? 0 : index * golden % count;
    return (static_cast<float>(place) + 0.5F) / static_cast<float>(count);
}

math::Vec2 jitter_px(std::uint32_t index, std::uint32_t count) {
    const float half = 0.5F / static_cast<float>(count);
    const float x = (static_cast<float>(index) + 0.5F) / static_cast<float>(count) - 0.5F;
    // Exact N-rooks where count is a power of two; elsewhere van der Corput's points are as good.
    return {x, count == 1 ? 0.0F : radical_inverse(index) + half - 0.5F};
}

}  // namespace facet::frame
