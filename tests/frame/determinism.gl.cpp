// Same inputs, same bytes; and the two ways to a context agree.
// SPDX-License-Identifier: MIT
#include "support/frame_harness.h"

#include <gtest/gtest.h>

namespace facet::test {
namespace {

Shot lit_sphere() {
    Shot shot{.scene = scene_of(sphere(48), material({0.8F, 0.3F, 0.1F}, 0.3F, 0.4F)),
              .latlong = constant_environment(math::Vec3(0.4F)),
              .samples = 4};
    shot.scene.lights = {
        {.kind = tables::LightKind::directional, .intensity = 3.0F},
        {.kind = tables::LightKind::point, .intensity = 2.0F, .position_m = {1, 1, 1}}};
    return shot;
}

TEST(Determinism, TheThreadCountDoesNotChangeAByte) {
    Shot shot = lit_sphere();
    Harness harness;
    shot.threads = 1;
    const auto one = harness.draw(shot);
    shot.threads = 4;
    const auto four = harness.draw(shot);
    ASSERT_TRUE(one && four);
    EXPECT_EQ(one->radiance.bytes, four->radiance.bytes);
}

TEST(Determinism, EglAndOsMesaAgree) {
    const Shot shot = lit_sphere();
    base::Result<Picture> egl = Harness(gl::Backend::egl).draw(shot);
    base::Result<Picture> osmesa = Harness(gl::Backend::osmesa).draw(shot);
    ASSERT_TRUE(egl) << base::to_line(egl.error());
    ASSERT_TRUE(osmesa) << base::to_line(osmesa.error());
    EXPECT_EQ(egl->radiance.bytes, osmesa->radiance.bytes) << "both are the same driver";
}

TEST(Jitter, SamplesAreCentredAndSpread) {
    for (const std::uint32_t count : {1U, 4U, 8U, 32U}) {
        math::Vec2 sum(0.0F);
        for (std::uint32_t i = 0; i < count; ++i) {
            const math::Vec2 j = frame::jitter_px(i, count);
            EXPECT_LE(std::fabs(j.x), 0.5F);
            EXPECT_LE(std::fabs(j.y), 0.5F);
            sum += j;
        }
        EXPECT_NEAR(sum.x, 0.0F, 1e-5F) << count;
        EXPECT_NEAR(sum.y, 0.0F, 1e-5F) << count;
    }
}

}  // namespace
}  // namespace facet::test
