// Half floats.
// SPDX-License-Identifier: MIT
#include "math/half.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace facet::math {
namespace {

TEST(Half, EveryFiniteHalfSurvivesTheWayToFloatAndBack) {
    for (std::uint32_t bits = 0; bits < 0x7C00U; ++bits)
        ASSERT_EQ(half_from_radiance(float_from_half(static_cast<std::uint16_t>(bits))), bits);
}

TEST(Half, ValuesBetweenTwoHalvesGoToTheNearerAndTiesToEven) {
    for (std::uint32_t bits = 0; bits < 0x7BFEU; bits += 7) {
        const float low = float_from_half(static_cast<std::uint16_t>(bits));
        const float high = float_from_half(static_cast<std::uint16_t>(bits + 1));
        EXPECT_EQ(half_from_radiance(low + 0.25F * (high - low)), bits);
        EXPECT_EQ(half_from_radiance(low + 0.75F * (high - low)), bits + 1);
        EXPECT_EQ(half_from_radiance(low + 0.5F * (high - low)), bits + (bits & 1U)) << bits;
    }
}

TEST(Half, SignInfinityAndNotANumberAreReadAsTheyAre) {
    EXPECT_EQ(float_from_half(0xC000), -2.0F);
    EXPECT_EQ(float_from_half(0x7C00), std::numeric_limits<float>::infinity());
    EXPECT_TRUE(std::isnan(float_from_half(0x7E00)));
}

}  // namespace
}  // namespace facet::math
