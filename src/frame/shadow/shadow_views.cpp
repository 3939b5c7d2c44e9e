// Where the shadow maps of a picture's lights look.
// SPDX-License-Identifier: MIT
#include "frame/shadow/shadow_views.h"

#include "scene/camera_spec.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facet::frame {
namespace {

using math::Mat4;
using math::Vec2;
using math::Vec3;
using math::Vec4;
using scene::Light;

constexpr std::uint32_t most_cascades = 3;
constexpr std::uint32_t most_tiles =
    (shadow_atlas_px / shadow_tile_min_px) * (shadow_atlas_px / shadow_tile_min_px);
constexpr float widest_cone_rad = 1.0472F;
/// Of a cube's face beyond its 90 degrees: room for the filter.
constexpr float cube_margin = 0.03F;
/// Of the way from evenly spaced splits to those by ratio.
constexpr float ratio_share = 0.7F;

struct Sphere {
    Vec3 center_m{0.0F};
    float radius_m = 0.0F;
};
Sphere sphere_of(const math::Bounds& bounds) { return {bounds.center(), 0.5F * bounds.diagonal()}; }

/// Looks along `ahead`; x and y are any two axes at right angles.
Mat4 view_from_world(const Vec3& eye, const Vec3& x, const Vec3& y, const Vec3& ahead) {
    Mat4 world_from_view(1.0F);
    world_from_view[0] = Vec4(x, 0.0F);
    world_from_view[1] = Vec4(y, 0.0F);
    world_from_view[2] = Vec4(-ahead, 0.0F);
    world_from_view[3] = Vec4(eye, 1.0F);
    return math::inverse(world_from_view);
}

/// GL's matrix with the tangent of half the angle of view.
ShadowView perspective(const Mat4& view, float tangent, float near_m, float far_m) {
    Mat4 clip(0.0F);
    clip[0][0] = 1.0F / tangent;
    clip[1][1] = 1.0F / tangent;
    clip[2][2] = -(far_m + near_m) / (far_m - near_m);
    clip[2][3] = -1.0F;
    clip[3][2] = -2.0F * far_m * near_m / (far_m - near_m);
    return {clip * view, near_m, far_m, 0.5F / tangent};
}

/// Distances along the camera's axis between which the scene is.
Vec2 depth_range(const scene::Camera& camera, const math::Bounds& bounds) {
    const Mat4 view = scene::view_from_world(camera);
    Vec2 range(1e30F, 0.0F);
    for (int i = 0; i < 8; ++i) {
        const Vec3 corner((i & 1) != 0 ? bounds.high.x : bounds.low.x,
                          (i & 2) != 0 ? bounds.high.y : bounds.low.y,
                          (i & 4) != 0 ? bounds.high.z : bounds.low.z);
        const float depth = -(view * Vec4(corner, 1.0F)).z;
        range = {std::min(range.x, depth), std::max(range.y, depth)};
    }
    const float nearest = std::max(range.x, camera.near_m);
    return {nearest, std::max(range.y, nearest * 1.001F + 1e-6F)};
}

/// Around what the camera sees between two depths.
Sphere slice(const scene::Camera& camera, math::Extent picture, float near_m, float far_m) {
    const Mat4 clip = scene::clip_from_view(camera, picture, Vec2(0.0F));
    const bool is_perspective = camera.projection == scene::Projection::perspective;
    std::array<Vec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const float depth = (i & 4U) != 0 ? far_m : near_m;
        const float spread = is_perspective ? depth : 1.0F;
        const Vec4 at(((i & 1U) != 0 ? spread : -spread) / clip[0][0],
                      ((i & 2U) != 0 ? spread : -spread) / clip[1][1], -depth, 1.0F);
        corners[i] = Vec3(camera.world_from_view * at);
    }
    Sphere out;
    for (const Vec3& c : corners) out.center_m += c / 8.0F;
    for (const Vec3& c : corners)
        out.radius_m = std::max(out.radius_m, math::length(c - out.center_m));
    return out;
}

ShadowView parallel(const Light& light, const Sphere& around, const Sphere& scene,
                    std::uint32_t map_px) {
    const scene::LightAxes axes = scene::axes_of(light);
    // By whole texels, so that edges stand still while the camera moves.
    const float texel_m = 2.0F * around.radius_m / static_cast<float>(map_px);
    const auto snapped = [&](float x) { return std::floor(x / texel_m) * texel_m; };
    const float x = snapped(math::dot(around.center_m, axes.x));
    const float y = snapped(math::dot(around.center_m, axes.y));
    const float depth_m = 2.02F * scene.radius_m;
    const float start = math::dot(scene.center_m, axes.z) - 0.5F * depth_m;
    const Vec3 eye = axes.x * x + axes.y * y + axes.z * start;
    Mat4 clip(1.0F);
    clip[0][0] = 1.0F / around.radius_m;
    clip[1][1] = 1.0F / around.radius_m;
    clip[2][2] = -2.0F / depth_m;
    clip[3][2] = -1.0F;
    return {clip * view_from_world(eye, axes.x, axes.y, axes.z), 0.0F, depth_m,
            0.5F / around.radius_m};
}

/// A parallel view, which may begin at 0, is as wide everywhere: even slices.
float split(const scene::Camera& camera, Vec2 range, std::uint32_t i, std::uint32_t count) {
    const float share = static_cast<float>(i) / static_cast<float>(count);
    const float even = std::lerp(range.x, range.y, share);
    if (camera.projection != scene::Projection::perspective) return even;
    return std::lerp(even, range.x * std::pow(range.y / range.x, share), ratio_share);
}

float radius_of(const Light& light) {
    if (light.kind == tables::LightKind::directional) return std::tan(0.5F * light.angle_rad);
    if (light.kind == tables::LightKind::sphere) return light.radius_m;
    if (light.kind == tables::LightKind::tube)
        return std::sqrt(2.0F * light.radius_m * light.width_m / math::pi);
    return std::sqrt(scene::area_m2(light) / math::pi);
}

ShadowKind kind_of(const Light& light) {
    if (light.kind == tables::LightKind::directional) return ShadowKind::parallel;
    const bool is_cone =
        light.kind == tables::LightKind::spot && light.outer_cone_rad <= widest_cone_rad;
    return is_cone ? ShadowKind::cone : ShadowKind::cube;
}

std::uint32_t views_of(ShadowKind kind, std::uint32_t cascades) {
    return kind == ShadowKind::parallel ? cascades : kind == ShadowKind::cone ? 1 : 6;
}

/// From a place, to one side or to all six: +x, -x, +y, -y, +z, -z, as shadow.glsl chooses.
void add_from_place(const Light& light, ShadowKind kind, const Sphere& scene,
                    std::vector<ShadowView>& views) {
    const Vec3& eye = light.position_m;
    float far_m = math::length(scene.center_m - eye) + scene.radius_m;
    if (light.range_m > 0.0F) far_m = std::min(far_m, light.range_m);
    const float near_m =
        std::min(std::max(1e-3F * far_m, light.kind == tables::LightKind::sphere ||
                                                 light.kind == tables::LightKind::tube
                                             ? light.radius_m
                                             : 0.0F),
                 0.5F * far_m);
    if (kind == ShadowKind::cone) {
        const scene::LightAxes axes = scene::axes_of(light);
        views.push_back(perspective(view_from_world(eye, axes.x, axes.y, axes.z),
                                    std::tan(light.outer_cone_rad) * (1.0F + cube_margin), near_m,
                                    far_m));
        return;
    }
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        Vec3 ahead(0.0F);
        ahead[axis] = face % 2 == 0 ? 1.0F : -1.0F;
        Vec3 x(0.0F);
        x[(axis + 1) % 3] = 1.0F;
        views.push_back(perspective(view_from_world(eye, x, math::cross(-ahead, x), ahead),
                                    1.0F + cube_margin, near_m, far_m));
    }
}

}  // namespace

ShadowPlan plan_shadow_views(std::span<const Light> lights, const scene::Camera& camera,
                             math::Extent picture, const math::Bounds& bounds_m) {
    ShadowPlan plan;
    plan.casters.resize(lights.size());
    if (bounds_m.is_empty()) return plan;
    const Sphere scene = sphere_of(bounds_m);
    const Vec2 range = depth_range(camera, bounds_m);
    std::array<Sphere, most_cascades> slices;
    for (std::uint32_t i = 0; i < most_cascades; ++i)
        slices[i] = slice(camera, picture, split(camera, range, i, most_cascades),
                          split(camera, range, i + 1, most_cascades));
    // Where the nearest slice is as large as the scene, one map shows all of it as finely.
    std::uint32_t cascades = most_cascades;
    if (slices[0].radius_m > 0.7F * scene.radius_m) {
        cascades = 1;
        slices[0] = scene;
    }
    for (Sphere& s : slices)
        if (s.radius_m > scene.radius_m) s = scene;
    std::uint32_t tiles = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const ShadowKind kind = kind_of(lights[i]);
        const std::uint32_t count = views_of(kind, cascades);
        if (!lights[i].casts_shadow) continue;
        if (tiles + count > most_tiles) continue;
        plan.casters[i] = {kind, tiles, count, radius_of(lights[i])};
        tiles += count;
    }
    while (plan.across * plan.across < tiles) plan.across *= 2;
    const std::uint32_t map_px = shadow_atlas_px / plan.across;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const ShadowKind kind = plan.casters[i].kind;
        if (kind == ShadowKind::none) continue;
        if (kind != ShadowKind::parallel)
            add_from_place(lights[i], kind, scene, plan.views);
        else
            for (std::uint32_t c = 0; c < cascades; ++c)
                plan.views.push_back(parallel(lights[i], slices[c], scene, map_px));
        for (std::uint32_t v = plan.casters[i].first; v < plan.views.size(); ++v)
            plan.views[v].light = i;
    }
    return plan;
}

}  // namespace facet::frame
