// The white furnace: in light of 1 from everywhere, a lossless surface shows 1 (physics: 6.5).
// SPDX-License-Identifier: MIT
#include "support/frame_harness.h"

#include <gtest/gtest.h>

namespace facet::test {
namespace {

TEST(Furnace, AWhiteSphereVanishesAtEveryRoughnessMetallicAndAngle) {
    Harness harness;
    for (const float metallic : {0.0F, 0.5F, 1.0F})
        for (const float roughness : {0.05F, 0.2F, 0.5F, 0.8F, 1.0F}) {
            Shot shot{
                .scene = scene_of(sphere(64), material(math::Vec3(1.0F), metallic, roughness)),
                .latlong = constant_environment(math::Vec3(1.0F))};
            const auto picture = harness.draw(shot);
            ASSERT_TRUE(picture) << base::to_line(picture.error());
            for (std::uint32_t y = 0; y < 64; ++y)
                for (std::uint32_t x = 0; x < 64; ++x) {
                    const math::Vec4 c = picture->at(x, y);
                    if (c.w < 1.0F) continue;
                    ASSERT_NEAR(c.x, 1.0F, 0.01F) << "metallic " << metallic << " roughness "
                                                  << roughness << " at " << x << "," << y;
                }
        }
}

TEST(Furnace, NoPixelIsNanAtTheEdgesOfTheParameters) {
    Harness harness;
    for (const float metallic : {0.0F, 1.0F})
        for (const float roughness : {0.0F, 1.0F}) {
            Shot shot{.scene = scene_of(
                          sphere(48), material(math::Vec3(1.0F, 0.0F, 0.5F), metallic, roughness)),
                      .latlong = constant_environment(math::Vec3(1.0F))};
            for (const math::Vec3 towards :
                 {math::Vec3(0, 0, 1), math::Vec3(0, 0, -1), math::Vec3(1, 0, 0)})
                shot.scene.lights.push_back({.kind = tables::LightKind::directional,
                                             .intensity = 1e5F,
                                             .direction = -towards});
            const auto picture = harness.draw(shot);
            ASSERT_TRUE(picture);
            for (const float value : picture->radiance.as<float>())
                ASSERT_TRUE(std::isfinite(value));
        }
}

// A mirror ball in an environment of two halves shows the upper one where its normal is tilted up
// by more than half the view's angle: reflect(-z, n).y > 0 is n.y > 0 for an orthographic view
// along -z.
TEST(Furnace, AMirrorBallShowsTheSkyAboveAndTheGroundBelow) {
    auto halves = std::make_shared<image::Image>(math::Extent{512, 256}, 3, image::Sample::f32);
    const auto values = halves->as<float>();
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = i < values.size() / 2 ? 2.0F : 0.5F;
    Harness harness;
    Shot shot{.scene = scene_of(sphere(96), material(math::Vec3(1.0F), 1.0F, 0.0F)),
              .latlong = halves};
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture);
    EXPECT_NEAR(picture->at(32, 16).x, 2.0F, 0.03F);
    EXPECT_NEAR(picture->at(32, 47).x, 0.5F, 0.03F);
}

}  // namespace
}  // namespace facet::test
