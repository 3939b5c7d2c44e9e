// Where shadow maps look: every place that may be lit is in one.
// SPDX-License-Identifier: MIT
#include "frame/shadow/shadow_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace facet::frame {
namespace {

using math::Vec3;
using scene::Light;
using tables::LightKind;

constexpr math::Extent picture{160, 90};
constexpr math::Bounds bounds{Vec3(-2.0F, 0.0F, -2.0F), Vec3(2.0F, 3.0F, 2.0F)};

/// Ten metres back, looking at the middle.
scene::Camera camera() {
    scene::Camera out;
    out.world_from_view[3] = math::Vec4(0.0F, 1.5F, 10.0F, 1.0F);
    return out;
}

Vec3 ndc(const ShadowView& view, const Vec3& place) {
    const math::Vec4 clip = view.clip_from_world * math::Vec4(place, 1.0F);
    return Vec3(clip) / clip.w;
}
bool is_inside(const Vec3& p) {
    return std::fabs(p.x) <= 1.0F && std::fabs(p.y) <= 1.0F && std::fabs(p.z) <= 1.0F;
}

std::vector<Vec3> places() {
    std::mt19937 random(1);
    const auto unit = [&] { return static_cast<float>(random()) / 4294967296.0F; };
    std::vector<Vec3> out;
    for (int i = 0; i < 500; ++i)
        out.push_back(bounds.low + (bounds.high - bounds.low) * Vec3(unit(), unit(), unit()));
    return out;
}

TEST(ShadowViews, OneOfThemSeesEachPlaceOfTheScene) {
    const std::vector<Light> lights = {
        {.kind = LightKind::directional, .direction = math::normalize(Vec3(1.0F, -2.0F, -1.0F))},
        {.kind = LightKind::point, .position_m = Vec3(0.3F, 2.0F, 0.1F)},
        {.kind = LightKind::sphere, .position_m = Vec3(5.0F, 4.0F, 0.0F), .radius_m = 0.5F}};
    const ShadowPlan plan = plan_shadow_views(lights, camera(), picture, bounds);
    ASSERT_EQ(plan.casters.size(), lights.size());
    for (const ShadowCaster& caster : plan.casters)
        for (const Vec3& place : places()) {
            int seen = 0;
            for (std::uint32_t i = 0; i < caster.count; ++i)
                seen += is_inside(ndc(plan.views[caster.first + i], place)) ? 1 : 0;
            EXPECT_GE(seen, 1) << place.x << ' ' << place.y << ' ' << place.z;
        }
    EXPECT_EQ(plan.casters[1].count, 6U);
    EXPECT_FLOAT_EQ(plan.casters[2].radius_m, 0.5F);
}

// glTF allows znear 0 there, and the scene may begin behind it.
TEST(ShadowViews, OfAParallelCameraThatBeginsAtTheEyeAreFinite) {
    scene::Camera parallel = camera();
    parallel.projection = scene::Projection::orthographic;
    parallel.near_m = 0.0F;
    parallel.world_from_view[3].z = 1.0F;
    const std::vector<Light> sun = {
        {.kind = LightKind::directional, .direction = math::normalize(Vec3(1.0F, -2.0F, -1.0F))}};
    const ShadowPlan plan = plan_shadow_views(sun, parallel, picture, bounds);
    ASSERT_FALSE(plan.views.empty());
    for (const ShadowView& view : plan.views)
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                EXPECT_TRUE(std::isfinite(view.clip_from_world[column][row]));
}

TEST(ShadowViews, ALightThatCastsNoShadowHasNone) {
    const std::vector<Light> lights = {{.kind = LightKind::point, .casts_shadow = false}};
    EXPECT_TRUE(plan_shadow_views(lights, camera(), picture, bounds).views.empty());
}

TEST(ShadowViews, CubeFacesAreInTheOrderThatTheShaderChoosesThem) {
    const std::vector<Light> lights = {{.kind = LightKind::point, .position_m = Vec3(0.0F)}};
    const ShadowPlan plan = plan_shadow_views(lights, camera(), picture, bounds);
    for (int face = 0; face < 6; ++face) {
        Vec3 way(0.1F, -0.2F, 0.15F);
        way[face / 2] = face % 2 == 0 ? 1.0F : -1.0F;
        const math::Vec4 clip =
            plan.views[static_cast<std::size_t>(face)].clip_from_world * math::Vec4(way, 1.0F);
        EXPECT_NEAR(clip.w, 1.0F, 1e-5F) << face;
        EXPECT_TRUE(is_inside(Vec3(clip) / clip.w)) << face;
    }
}

TEST(ShadowViews, ParallelMapsMoveByWholeTexels) {
    const std::vector<Light> lights = {
        {.kind = LightKind::directional, .direction = math::normalize(Vec3(1.0F, -2.0F, -1.0F))}};
    scene::Camera near = camera();
    near.world_from_view[3] = math::Vec4(0.0F, 1.5F, 2.5F, 1.0F);  // slices are less than the scene
    scene::Camera moved = near;
    moved.world_from_view[3].x = 0.123F;
    const ShadowPlan a = plan_shadow_views(lights, near, picture, bounds);
    const ShadowPlan b = plan_shadow_views(lights, moved, picture, bounds);
    ASSERT_GT(a.casters[0].count, 1U);
    const float half_texels =
        0.5F * static_cast<float>(shadow_atlas_px) / static_cast<float>(a.across);
    for (std::size_t i = 0; i < a.views.size(); ++i) {
        const Vec3 apart =
            (ndc(a.views[i], Vec3(0.0F)) - ndc(b.views[i], Vec3(0.0F))) * half_texels;
        EXPECT_NEAR(apart.x, std::round(apart.x), 0.02F);
        EXPECT_NEAR(apart.y, std::round(apart.y), 0.02F);
    }
}

TEST(ShadowViews, LightsWithoutRoomAreLeftLit) {
    const std::vector<Light> lights(
        60, {.kind = LightKind::point, .position_m = Vec3(0.0F, 5.0F, 0.0F)});
    const ShadowPlan plan = plan_shadow_views(lights, camera(), picture, bounds);
    EXPECT_EQ(plan.across, 16U);
    EXPECT_EQ(plan.views.size(), 252U);
    EXPECT_EQ(plan.casters[41].count, 6U);
    EXPECT_EQ(plan.casters[42].count, 0U);
}

TEST(ShadowViews, NothingIsMadeOfAnEmptyScene) {
    const std::vector<Light> lights(1);
    EXPECT_TRUE(plan_shadow_views(lights, camera(), picture, {}).views.empty());
}

}  // namespace
}  // namespace facet::frame
