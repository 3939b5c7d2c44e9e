// Volumes within volumes. SPDX-License-Identifier: MIT
#include "trace/medium.h"

#include <gtest/gtest.h>

namespace facet::trace {
namespace {

using math::Vec3;

/// The near or the far side of a volume.
Surface boundary(std::uint32_t material, float ior, bool is_front) {
    Surface surface;
    surface.has_volume = true;
    surface.material = material;
    surface.ior = ior;
    surface.extinction_per_m = Vec3(static_cast<float>(material));
    surface.front = is_front;
    return surface;
}

TEST(Medium, IsWhatTheDrinkIsWhereItOverlapsWithItsGlass) {
    Medium medium;
    Sequence sequence(0, 0, 0);
    const auto around = [&](Surface surface) {
        EXPECT_EQ(medium.meet(surface, sequence), Vec3(1.0F));
        const float out = surface.ior_around;
        medium.cross(surface);
        return out;
    };
    EXPECT_EQ(around(boundary(1, 1.5F, true)), 1.0F);   // into the glass
    EXPECT_EQ(around(boundary(2, 1.33F, true)), 1.5F);  // into the drink within its wall
    EXPECT_EQ(around(boundary(1, 1.5F, false)), 1.5F);  // the wall ends: nothing bends
    EXPECT_EQ(medium.extinction_per_m(), Vec3(2.0F));
    EXPECT_EQ(around(boundary(1, 1.5F, true)), 1.33F);    // the other wall begins
    EXPECT_EQ(around(boundary(2, 1.33F, false)), 1.33F);  // the drink ends within it
    EXPECT_EQ(medium.extinction_per_m(), Vec3(1.0F));
    EXPECT_EQ(around(boundary(1, 1.5F, false)), 1.0F);  // out
    EXPECT_EQ(medium.extinction_per_m(), Vec3(0.0F));
}

TEST(Medium, FindsBackFromMoreVolumesThanItKeeps) {
    Medium medium;
    for (std::uint32_t i = 1; i <= 9; ++i) medium.cross(boundary(i, 1.5F, true));
    for (std::uint32_t i = 9; i > 1; --i) medium.cross(boundary(i, 1.5F, false));
    EXPECT_EQ(medium.extinction_per_m(), Vec3(1.0F));
    for (int i = 0; i < 3; ++i) medium.cross(boundary(1, 1.5F, false));
    EXPECT_EQ(medium.extinction_per_m(), Vec3(0.0F));
}

}  // namespace
}  // namespace facet::trace
