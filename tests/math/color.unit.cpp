// Colour spaces against published figures.
// SPDX-License-Identifier: MIT
#include "math/color.h"

#include "math/blackbody.h"

#include <gtest/gtest.h>

namespace facet::math {
namespace {

// Matrices of SMPTE RP 177's method, as the W3C's CSS Color 4 prints them (2024, section 18).
TEST(Color, OtherPrimariesAreThoseOfTheirStandards) {
    const Mat3 p3 = p3_from_rec709();
    EXPECT_NEAR(p3[0][0], 0.8224620F, 1e-5F);
    EXPECT_NEAR(p3[1][0], 0.1775380F, 1e-5F);
    EXPECT_NEAR(p3[0][2], 0.0170826F, 1e-5F);
    // ITU-R BT.2087-0, Eq. for M2.
    const Mat3 rec2020 = rec2020_from_rec709();
    EXPECT_NEAR(rec2020[0][0], 0.6274F, 1e-4F);
    EXPECT_NEAR(rec2020[1][0], 0.3293F, 1e-4F);
    EXPECT_NEAR(rec2020[0][1], 0.0691F, 1e-4F);
    EXPECT_NEAR(rec2020[2][2], 0.8956F, 1e-4F);
    for (const Mat3& m : {p3, rec2020}) {
        const Vec3 white = m * Vec3(1.0F);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1.0F, 1e-5F);
    }
}

TEST(Color, LightThatEyesAreUsedToIsGreyOfItsLuminance) {
    for (const float kelvin : {2000.0F, 3200.0F, 5500.0F, 12000.0F}) {
        const Vec3 light = blackbody_color(kelvin);
        const Vec3 seen = adapted_from(light) * light;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], 1.0F, 1e-3F) << kelvin;
    }
    const Mat3 none = adapted_from(Vec3(0.5F));
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) EXPECT_NEAR(none[i][j], i == j ? 1.0F : 0.0F, 1e-5F);
}

}  // namespace
}  // namespace facet::math
