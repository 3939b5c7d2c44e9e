// The scrambled Sobol points: nets in base 2 whatever the pixel, the pair and the seed.
// SPDX-License-Identifier: MIT
#include "trace/sequence.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace facet::trace {
namespace {

std::vector<math::Vec2> points(std::uint32_t count, std::uint32_t pixel, std::uint32_t pair) {
    std::vector<math::Vec2> out;
    for (std::uint32_t i = 0; i < count; ++i) {
        Sequence sequence(pixel, i, 7);
        for (std::uint32_t skipped = 0; skipped < pair; ++skipped) (void)sequence.next_pair();
        out.push_back(sequence.next_pair());
    }
    return out;
}

// The definition of a (0, k, 2)-net in base 2 (Niederreiter 1992, Section 4.1).
TEST(Sequence, EveryElementaryIntervalOfTheFirst256PointsHoldsOnePoint) {
    for (const std::uint32_t pixel : {0U, 1U, 12345U})
        for (const std::uint32_t pair : {0U, 3U})
            for (int k = 0; k <= 8; ++k) {
                std::set<std::pair<int, int>> cells;
                const float columns = static_cast<float>(1 << k);
                const float rows = static_cast<float>(1 << (8 - k));
                for (const math::Vec2& p : points(256, pixel, pair))
                    cells.emplace(static_cast<int>(p.x * columns), static_cast<int>(p.y * rows));
                EXPECT_EQ(cells.size(), 256U)
                    << "pixel " << pixel << " pair " << pair << " 2^" << k;
            }
}

TEST(Sequence, LonePixelsAndPairsAreNotAlike) {
    const auto a = points(64, 1, 0);
    int same = 0;
    for (const auto& b : {points(64, 2, 0), points(64, 1, 1)})
        for (std::size_t i = 0; i < a.size(); ++i) same += a[i] == b[i] ? 1 : 0;
    EXPECT_LE(same, 1);
}

TEST(Sequence, NumbersAreBelowOneAndTheSingleDimensionIsStratified) {
    std::set<int> cells;
    for (std::uint32_t i = 0; i < 1024; ++i) {
        Sequence sequence(99, i, 0);
        const float x = sequence.next();
        ASSERT_GE(x, 0.0F);
        ASSERT_LT(x, 1.0F);
        cells.insert(static_cast<int>(x * 1024.0F));
    }
    EXPECT_EQ(cells.size(), 1024U);
}

// Sobol's second dimension by its direction numbers v_i = v_(i-1) xor (v_(i-1) >> 1) (Bratley & Fox
// 1988).
TEST(Sequence, PascalProductIsSobolsSecondDimension) {
    for (std::uint32_t index : {1U, 2U, 3U, 77U, 0x80000001U, 0xDEADBEEFU}) {
        std::uint32_t expected = 0;
        std::uint32_t direction = 1U << 31U;
        for (std::uint32_t bits = index; bits != 0; bits >>= 1U, direction ^= direction >> 1U)
            if ((bits & 1U) != 0) expected ^= direction;
        EXPECT_EQ(reversed_bits(pascal_product(index)), expected) << index;
    }
}

}  // namespace
}  // namespace facet::trace
