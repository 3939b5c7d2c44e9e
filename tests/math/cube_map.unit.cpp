// Places on a cube map and their directions.
// SPDX-License-Identifier: MIT
#include "math/cube_map.h"

#include <gtest/gtest.h>

namespace facet::math {
namespace {

TEST(CubeMap, DirectionOfAPlaceLeadsBackToThatPlace) {
    for (std::uint32_t face = 0; face < 6; ++face)
        for (float s = -0.95F; s < 1.0F; s += 0.19F)
            for (float t = -0.95F; t < 1.0F; t += 0.19F) {
                const CubePoint back =
                    cube_point_from(3.0F * direction_from(CubePoint{face, s, t}));
                EXPECT_EQ(back.face, face);
                EXPECT_NEAR(back.s, s, 1e-6F);
                EXPECT_NEAR(back.t, t, 1e-6F);
            }
}

// OpenGL 4.5, table 8.19: major axis, sc and tc of each face.
TEST(CubeMap, FacesAreOrientedAsOpenGlSays) {
    EXPECT_EQ(direction_from(CubePoint{0, 0.5F, 0.25F}), Vec3(1.0F, -0.25F, -0.5F));
    EXPECT_EQ(direction_from(CubePoint{1, 0.5F, 0.25F}), Vec3(-1.0F, -0.25F, 0.5F));
    EXPECT_EQ(direction_from(CubePoint{2, 0.5F, 0.25F}), Vec3(0.5F, 1.0F, 0.25F));
    EXPECT_EQ(direction_from(CubePoint{3, 0.5F, 0.25F}), Vec3(0.5F, -1.0F, -0.25F));
    EXPECT_EQ(direction_from(CubePoint{4, 0.5F, 0.25F}), Vec3(0.5F, -0.25F, 1.0F));
    EXPECT_EQ(direction_from(CubePoint{5, 0.5F, 0.25F}), Vec3(-0.5F, -0.25F, -1.0F));
}

}  // namespace
}  // namespace facet::math
