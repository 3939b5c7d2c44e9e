// Mip levels: sizes, means in linear light, odd sides; and 8-bit RGBA of anything.
// SPDX-License-Identifier: MIT
#include "image/mips.h"

#include "math/color.h"
#include "support/image_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace facet {
namespace {

using image::Image;
using image::Sample;

Image plain(math::Extent size, std::uint8_t code) {
    Image out(size, 4, Sample::u8);
    std::ranges::fill(out.as<std::uint8_t>(), code);
    return out;
}

TEST(Mips, halve_down_to_one_pixel) {
    const auto levels = image::build_mips(plain({20, 5}, 9), true);
    const std::vector<math::Extent> sizes{{20, 5}, {10, 2}, {5, 1}, {2, 1}, {1, 1}};
    ASSERT_EQ(levels.size(), sizes.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) EXPECT_EQ(levels[i].size, sizes[i]);
}

TEST(Mips, every_constant_colour_stays_what_it_is) {
    for (const math::Extent size : {math::Extent{8, 8}, {7, 6}, {5, 3}, {1, 9}})
        for (const bool srgb : {false, true})
            for (int code = 0; code < 256; ++code) {
                const auto levels =
                    image::build_mips(plain(size, static_cast<std::uint8_t>(code)), srgb);
                for (const std::uint8_t byte : levels.back().as<std::uint8_t>())
                    ASSERT_EQ(byte, code) << size.width << 'x' << size.height << " srgb " << srgb;
            }
}

TEST(Mips, black_and_white_average_to_188_in_srgb_and_128_in_linear_data) {
    Image board = plain({2, 2}, 255);
    std::fill_n(board.as<std::uint8_t>().begin(), 4, std::uint8_t{0});
    std::fill_n(board.as<std::uint8_t>().begin() + 12, 4, std::uint8_t{0});
    const auto encoded = image::build_mips(board, true).back();
    EXPECT_NEAR(encoded.as<std::uint8_t>()[0], 188, 1);  // sRGB of linear 0.5
    EXPECT_NEAR(encoded.as<std::uint8_t>()[3], 128, 1) << "alpha is linear";
    EXPECT_NEAR(image::build_mips(board, false).back().as<std::uint8_t>()[0], 128, 1);
}

TEST(Mips, an_odd_side_weighs_every_pixel_the_same) {
    for (std::size_t lit = 0; lit < 5; ++lit) {
        Image row = plain({5, 1}, 0);
        row.as<std::uint8_t>()[lit * 4] = 250;
        const auto levels = image::build_mips(row, false);
        EXPECT_NEAR(levels[1].as<std::uint8_t>()[0] + levels[1].as<std::uint8_t>()[4], 100, 1)
            << lit;
    }
}

TEST(Mips, a_pool_changes_nothing) {
    base::ThreadPool pool(2);
    for (const math::Extent size : {math::Extent{128, 128}, {97, 130}}) {
        const Image in = test::sample_image(size, 4, Sample::u8);
        const auto alone = image::build_mips(in, true);
        const auto shared = image::build_mips(in, true, pool);
        ASSERT_EQ(alone.size(), shared.size());
        for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_EQ(alone[i].bytes, shared[i].bytes);
    }
}

TEST(Mips, a_random_picture_agrees_with_the_mean_in_double_precision) {
    const Image in = test::sample_image({64, 64}, 4, Sample::u8);
    const auto level = image::build_mips(in, true)[1];
    for (std::size_t y = 0; y < 32; ++y)
        for (std::size_t x = 0; x < 32; ++x) {
            double sum = 0.0;
            for (const std::size_t at : {0U, 4U, 256U, 260U})
                sum += static_cast<double>(math::linear_from_srgb(
                    static_cast<float>(in.as<std::uint8_t>()[y * 512 + x * 8 + at]) / 255.0F));
            const float mean = math::srgb_from_linear(static_cast<float>(sum / 4.0)) * 255.0F;
            EXPECT_NEAR(static_cast<float>(level.as<std::uint8_t>()[(y * 32 + x) * 4]), mean,
                        0.75F);
        }
}

TEST(ToRgba8, gray_and_missing_alpha_are_filled_in) {
    Image gray_alpha({1, 1}, 2, Sample::u8);
    gray_alpha.as<std::uint8_t>()[0] = 7;
    gray_alpha.as<std::uint8_t>()[1] = 9;
    const Image out = image::to_rgba8(gray_alpha);
    const std::vector<std::uint8_t> expected{7, 7, 7, 9};
    EXPECT_TRUE(std::ranges::equal(out.as<std::uint8_t>(), expected));
    Image word({1, 1}, 3, Sample::u16);
    word.as<std::uint16_t>()[0] = 65535;
    word.as<std::uint16_t>()[1] = 128 * 257 + 100;
    const Image narrow = image::to_rgba8(word);
    const std::vector<std::uint8_t> rounded{255, 128, 0, 255};
    EXPECT_TRUE(std::ranges::equal(narrow.as<std::uint8_t>(), rounded));
}

TEST(ToRgba8, every_sixteen_bit_value_is_rounded_to_the_nearest) {
    Image all({256, 256}, 1, Sample::u16);
    for (std::size_t i = 0; i < 65536; ++i)
        all.as<std::uint16_t>()[i] = static_cast<std::uint16_t>(i);
    const Image out = image::to_rgba8(all);
    for (std::size_t i = 0; i < 65536; ++i)
        ASSERT_EQ(out.as<std::uint8_t>()[i * 4], std::lround(static_cast<double>(i) / 257.0)) << i;
}

}  // namespace
}  // namespace facet
