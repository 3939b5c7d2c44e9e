// Cameras from text: names, orbits, framing, and the matrices of a view.
// SPDX-License-Identifier: MIT
#include "scene/camera_spec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace facet::scene {
namespace {

constexpr math::Extent wide{200, 100};

/// A box of `side_m` around the origin, with two cameras where asked for.
Scene box_scene(float side_m) {
    Scene scene;
    Mesh mesh;
    const float h = side_m * 0.5F;
    mesh.positions_m = {Vec3(-h), Vec3(h), Vec3(-h, h, h)};
    mesh.indices = {0, 1, 2};
    for (const Vec3& p : mesh.positions_m) mesh.bounds_m.add(p);
    scene.meshes = {mesh};
    scene.instances.resize(1);
    return scene;
}
Scene scene_with_cameras() {
    Scene scene = box_scene(2.0F);
    scene.cameras = {Camera{.name = "front", .node = "Node.A"},
                     Camera{.name = "1", .node = "back"}};
    scene.cameras[0].yfov_rad = 0.5F;
    scene.cameras[1].yfov_rad = 0.7F;
    return scene;
}
Vec3 eye(const Camera& camera) { return Vec3(camera.world_from_view[3]); }
base::Error error_of(const std::string& spec) {
    const auto camera = resolve_camera(scene_with_cameras(), spec, 0.0F, wide);
    EXPECT_FALSE(camera) << spec;
    return camera ? base::Error{} : camera.error();
}

TEST(ResolveCamera, FindsByNameByNodeAndByIndex) {
    const Scene scene = scene_with_cameras();
    EXPECT_EQ(resolve_camera(scene, "front", 0.0F, wide)->yfov_rad, 0.5F);
    EXPECT_EQ(resolve_camera(scene, "back", 0.0F, wide)->yfov_rad, 0.7F);
    EXPECT_EQ(resolve_camera(scene, "0", 0.0F, wide)->yfov_rad, 0.5F);
    EXPECT_EQ(resolve_camera(scene, "auto", 0.0F, wide)->yfov_rad, 0.5F);
}
TEST(ResolveCamera, TakesANameThatBeginsWithOrbit) {
    EXPECT_TRUE(is_orbit("orbit"));
    EXPECT_TRUE(is_orbit("orbit:azimuth=3"));
    EXPECT_FALSE(is_orbit("orbit1"));
    Scene scene;
    scene.cameras.push_back({.name = "orbit1"});
    scene.cameras.back().yfov_rad = 0.125F;
    const auto found = resolve_camera(scene, "orbit1", 0.0F, {64, 64});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->yfov_rad, 0.125F);
}

TEST(ResolveCamera, PrefersANameToAnIndex) {
    Scene scene = scene_with_cameras();
    scene.cameras[1].name.assign(1, '0');
    EXPECT_EQ(resolve_camera(scene, "0", 0.0F, wide)->yfov_rad, 0.7F);
}
TEST(ResolveCamera, ReplacesTheVerticalAngleWhereOneIsGiven) {
    const auto camera = resolve_camera(scene_with_cameras(), "front", 90.0F, wide);
    EXPECT_NEAR(camera->yfov_rad, math::pi / 2.0F, 1e-6F);
}
TEST(ResolveCamera, ListsTheCamerasWhenThereIsNoneOfThatName) {
    const base::Error error = error_of("fornt");
    EXPECT_EQ(error.code, base::ErrorCode::usage);
    EXPECT_EQ(error.found, "fornt");
    EXPECT_NE(error.remedy.find("front"), std::string::npos) << error.remedy;
    EXPECT_EQ(error_of("2").code, base::ErrorCode::usage);
    EXPECT_EQ(error_of("-1").code, base::ErrorCode::usage);
}

TEST(OrbitCamera, StandsWhereAzimuthAndElevationSay) {
    const Scene scene = box_scene(2.0F);
    const auto at = [&](const std::string& orbit) {
        return eye(*resolve_camera(scene, "orbit:target=0 0 0,distance=2," + orbit, 0.0F, wide));
    };
    EXPECT_LT(math::length(at("azimuth=0,elevation=0") - Vec3(0, 0, 2)), 1e-5F);
    EXPECT_LT(math::length(at("azimuth=90,elevation=0") - Vec3(2, 0, 0)), 1e-5F);
    EXPECT_LT(math::length(at("azimuth=0,elevation=90") - Vec3(0, 2, 0)), 1e-5F);
}
TEST(OrbitCamera, LooksAtItsTargetEvenFromStraightAbove) {
    const Scene scene = box_scene(2.0F);
    for (const char* const angles : {"azimuth=30,elevation=20", "elevation=90", "elevation=-90"}) {
        const auto camera = resolve_camera(
            scene, std::string("orbit:distance=5,target=1 2 3,") + angles, 0.0F, wide);
        ASSERT_TRUE(camera) << angles;
        const Vec4 seen = view_from_world(*camera) * Vec4(1, 2, 3, 1);
        EXPECT_LT(math::length(Vec3(seen) - Vec3(0, 0, -5)), 1e-4F) << angles;
    }
}
TEST(OrbitCamera, FitsTheWholeModelIntoThePictureWhateverItsShape) {
    const Scene scene = box_scene(2.0F);
    for (const math::Extent size : {wide, math::Extent{100, 300}}) {
        const auto camera = resolve_camera(scene, "orbit", 0.0F, size);
        ASSERT_TRUE(camera);
        const Mat4 clip = clip_from_view(*camera, size, Vec2(0.0F)) * view_from_world(*camera);
        float largest = 0.0F;
        for (int i = 0; i < 8; ++i) {
            const Vec4 p =
                clip * Vec4((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1, 1);
            largest = std::max({largest, std::fabs(p.x / p.w), std::fabs(p.y / p.w)});
            EXPECT_LT(std::fabs(p.z / p.w), 1.0F);
        }
        EXPECT_LT(largest, 1.0F);
        EXPECT_GT(largest, 0.85F);
    }
}
TEST(OrbitCamera, StaysFiniteForModelsOfNoExtentAndOfAVastOne) {
    for (const float side_m : {0.0F, 1e-20F, 1e20F, std::numeric_limits<float>::max()}) {
        const auto camera = resolve_camera(box_scene(side_m), "auto", 0.0F, wide);
        ASSERT_TRUE(camera) << side_m;
        const Mat4 clip = clip_from_view(*camera, wide, Vec2(0.0F)) * view_from_world(*camera);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) EXPECT_TRUE(std::isfinite(clip[c][r])) << side_m;
    }
}
/// Distance of an orbit's eye from a long flat box, whose middle is the origin.
float distance_of(const std::string& spec) {
    Scene scene = box_scene(1.0F);
    for (Mesh& mesh : scene.meshes) {
        for (Vec3& p : mesh.positions_m)
            p = (p - scene.bounds_m().center()) * Vec3(4.0F, 1.0F, 0.2F);
        mesh.bounds_m = {};
        for (const Vec3& p : mesh.positions_m) mesh.bounds_m.add(p);
    }
    const Vec3 middle = scene.bounds_m().center();
    const auto camera = resolve_camera(scene, spec, 0.0F, wide);
    EXPECT_TRUE(camera) << spec;
    return camera ? math::length(Vec3(camera->world_from_view[3]) - middle) : 0.0F;
}
TEST(OrbitCamera, AFitOfAllAzimuthsKeepsItsDistance) {
    const float face = distance_of("orbit:azimuth=0,elevation=10");
    const float edge = distance_of("orbit:azimuth=90,elevation=10");
    EXPECT_GT(std::fabs(face - edge), 0.2F) << "as it is seen, a long box fits differently";
    const float turned = distance_of("orbit:azimuth=0,elevation=10,fit=turn");
    EXPECT_GE(turned, std::max(face, edge));
    for (const char* azimuth : {"37", "90", "200.5"})
        EXPECT_NEAR(distance_of("orbit:azimuth=" + std::string(azimuth) + ",elevation=10,fit=turn"),
                    turned, 1e-5F * turned);
    EXPECT_GE(distance_of("orbit:elevation=80,fit=sphere"), turned);
    EXPECT_EQ(error_of("orbit:fit=trun").code, base::ErrorCode::usage);
}
TEST(OrbitCamera, TurnsAroundTheModel) {
    EXPECT_EQ(*turned_orbit("auto", 90.0), "orbit:azimuth=125,elevation=15,fit=turn");
    EXPECT_EQ(*turned_orbit("orbit:azimuth=300,distance=2,target=0 1 0", 90.0),
              "orbit:azimuth=30,elevation=15,target=0 1 0,distance=2");
    EXPECT_FALSE(turned_orbit("hero", 10.0));
}
TEST(OrbitCamera, NamesTheNearestKeyOfAMisspeltOne) {
    const base::Error error = error_of("orbit:azimut=3");
    EXPECT_EQ(error.code, base::ErrorCode::usage);
    EXPECT_NE(error.remedy.find("azimuth"), std::string::npos) << error.remedy;
}
TEST(OrbitCamera, RefusesValuesThatAreNotFiniteNumbersInRange) {
    for (const char* const bad :
         {"orbit:azimuth=nan", "orbit:elevation=inf", "orbit:azimuth", "orbit:azimuth=1e300",
          "orbit:distance=0", "orbit:distance=-1", "orbit:target=1 2", "orbit:target=1 2 3 4",
          "orbit:target=1 2 nan", "orbit:target=1e300 0 0"})
        EXPECT_EQ(error_of(bad).code, base::ErrorCode::usage) << bad;
}

TEST(ClipFromView, MapsTheEdgesOfThePictureToOne) {
    Camera camera;
    camera.yfov_rad = math::pi / 2.0F;
    const Vec4 corner = clip_from_view(camera, wide, Vec2(0.0F)) * Vec4(2, 1, -1, 1);
    EXPECT_NEAR(corner.x / corner.w, 1.0F, 1e-6F);
    EXPECT_NEAR(corner.y / corner.w, 1.0F, 1e-6F);
}
TEST(ClipFromView, JitterMovesThePictureAgainstTheSampleByPixels) {
    Camera camera;
    const Vec4 ahead(0, 0, -3, 1);
    const Vec4 moved = clip_from_view(camera, wide, Vec2(0.5F, 0.25F)) * ahead;
    EXPECT_NEAR(moved.x / moved.w, -2.0F * 0.5F / 200.0F, 1e-6F);
    EXPECT_NEAR(moved.y / moved.w, 2.0F * 0.25F / 100.0F, 1e-6F);
}

}  // namespace
}  // namespace facet::scene
