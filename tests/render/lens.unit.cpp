// The thin lens and the exposure of a camera against closed forms.
// SPDX-License-Identifier: MIT
#include "scene/lens.h"

#include "frame/view.h"
#include "scene/camera_spec.h"
#include "trace/camera.h"

#include <gtest/gtest.h>

#include <set>

namespace facet::scene {
namespace {

Camera camera_at_origin() {
    Camera camera;
    camera.yfov_rad = 2.0F * std::atan(0.012F / 0.05F);  // a 50 mm lens
    camera.lens_radius_m = lens_radius_m(camera.yfov_rad, 2.0F);
    camera.focus_m = 2.0F;
    return camera;
}

TEST(Lens, FocalLengthAndPupilAreThoseOfTheFullFrameFormat) {
    const Camera camera = camera_at_origin();
    EXPECT_NEAR(focal_length_m(camera.yfov_rad), 0.05F, 1e-6F);
    EXPECT_NEAR(camera.lens_radius_m, 0.0125F, 1e-6F);
}

// physics.md 11.1: EV 15 is f/16 at 1/128 s and ISO 100.
TEST(Lens, ExposureValueIsThatOfIso2720) {
    EXPECT_NEAR(exposure_value(16.0, 1.0 / 128.0, 100.0), 15.0, 1e-9);
    EXPECT_NEAR(exposure_value(8.0, 1.0 / 64.0, 200.0), 11.0, 1e-9);
}

// Any count of samples: each has a time of its own, and their mean is the middle.
TEST(Lens, TimesOfSamplesAreEven) {
    for (std::uint32_t count = 1; count <= 100; ++count) {
        double sum = 0.0;
        std::set<float> times;
        for (std::uint32_t i = 0; i < count; ++i) {
            times.insert(frame::sample_time(i, count));
            sum += static_cast<double>(frame::sample_time(i, count));
        }
        EXPECT_EQ(times.size(), count);
        EXPECT_NEAR(sum / count, 0.5, 1e-5) << count;
    }
}

TEST(Lens, TheFirstSampleLooksThroughItsMiddle) {
    for (const std::uint32_t blades : {0U, 6U}) {
        Camera camera = camera_at_origin();
        camera.blades = blades;
        const auto view = frame::sample_view(camera, {64, 64}, {0, 0, {64, 64}}, 0, 1);
        EXPECT_LT(math::length(Vec3(view.eye_m)), 1e-7F) << blades;
    }
}

TEST(Lens, PlacesAreEvenOverADiskAndWithinAPolygon) {
    Camera camera = camera_at_origin();
    constexpr int side = 200;
    double inner = 0.0;
    for (int i = 0; i < side * side; ++i) {
        const Vec2 u((float(i % side) + 0.5F) / side, (float(i / side) + 0.5F) / side);
        camera.blades = 0;
        const Vec2 p = place_on_lens(camera, u) / camera.lens_radius_m;
        EXPECT_LE(math::length(p), 1.00001F);
        if (math::length(p) < 0.5F) inner += 1.0;
        camera.blades = 6;
        const Vec2 q = place_on_lens(camera, u) / camera.lens_radius_m;
        // A hexagon with a corner at the top lies within sqrt(3) / 2 of its middle, sideways.
        EXPECT_LE(std::fabs(q.x), 0.8661F);
    }
    EXPECT_NEAR(inner / (side * side), 0.25, 0.005);
}

/// Where a point on the axis falls, in pixels from the middle, seen from the edge of the lens.
float raster_offset_px(const Camera& camera, float depth_m, std::uint32_t height) {
    const math::Extent picture{height, height};
    const auto view = frame::view_block(camera, picture, {0, 0, picture}, Vec2(0.0F),
                                        {camera.lens_radius_m, 0.0F});
    const Vec4 clip = view.clip_from_world * Vec4(0.0F, 0.0F, -depth_m, 1.0F);
    return 0.5F * static_cast<float>(height) * clip.x / clip.w;
}

// The circle of confusion of f/2 and 50 mm at 2 m: (f/N) f |s - s_f| / (s s_f) of 24 mm of height.
TEST(Lens, CircleOfConfusionIsTheThinLensOneInRasterAndReference) {
    const Camera camera = camera_at_origin();
    constexpr std::uint32_t height = 1000;
    for (const float depth : {1.0F, 1.5F, 2.0F, 3.0F, 10.0F}) {
        const float expected_px =
            0.025F * 0.05F * std::fabs(depth - 2.0F) / (depth * 2.0F) / 0.024F * height;
        EXPECT_NEAR(2.0F * std::fabs(raster_offset_px(camera, depth, height)), expected_px, 0.05F)
            << depth;
        // The reference's ray through that pixel from that place on the lens meets the point.
        const trace::CameraRays rays(camera, {height, height});
        const float x = 0.5F * height + raster_offset_px(camera, depth, height);
        const auto ray = rays.ray({x, 0.5F * height}, {.lens_m = {camera.lens_radius_m, 0.0F}});
        const Vec3 at = ray.origin + ray.direction * (-depth / ray.direction.z);
        EXPECT_NEAR(at.x, 0.0F, 1e-4F) << depth;
    }
}

TEST(Projection, BothShowTheSameAtTheScenesMiddle) {
    Scene scene;
    Camera camera = camera_at_origin();
    camera.world_from_view[3] = Vec4(0.0F, 0.0F, 4.0F, 1.0F);
    const float angle = camera.yfov_rad;
    set_projection(camera, scene, "orthographic");
    EXPECT_EQ(camera.projection, Projection::orthographic);
    EXPECT_NEAR(camera.ymag_m, 4.0F * 0.24F, 1e-5F);
    set_projection(camera, scene, "perspective");
    EXPECT_NEAR(camera.yfov_rad, angle, 1e-5F);
}

}  // namespace
}  // namespace facet::scene
