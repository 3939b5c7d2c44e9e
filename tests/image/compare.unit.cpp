// Differences of pictures with known answers.
// SPDX-License-Identifier: MIT
#include "image/compare.h"

#include "image/flip.h"
#include "math/color.h"
#include "support/image_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace facet {
namespace {

using image::Image;
using image::Layer;
using image::Picture;
using image::Sample;

Picture picture(Image image, tables::ImageFormat format = tables::ImageFormat::png) {
    Picture out;
    out.format = format;
    out.layers.push_back({"", std::vector<std::string>(image.channels, "R"), std::move(image)});
    return out;
}
Image plain(std::uint8_t code, math::Extent size = {32, 24}, std::uint32_t channels = 3) {
    Image out(size, channels, Sample::u8);
    std::ranges::fill(out.as<std::uint8_t>(), code);
    return out;
}

TEST(Compare, equal_pictures_differ_by_nothing) {
    const Picture a = picture(test::sample_image({40, 30}, 3, Sample::u8));
    const auto d = image::compare(a, a);
    ASSERT_TRUE(d);
    EXPECT_EQ(d->rmse, 0.0);
    EXPECT_EQ(d->psnr_db, std::numeric_limits<double>::infinity());
    EXPECT_EQ(d->max_error, 0.0);
    EXPECT_EQ(d->flip, 0.0);
    EXPECT_EQ(d->pixel_count, 1200U);
    EXPECT_TRUE(std::ranges::all_of(d->heat.bytes, [](std::byte b) { return b == std::byte{0}; }));
}

TEST(Compare, a_constant_distance_is_the_rmse) {
    const auto d = image::compare(picture(plain(51)), picture(plain(102)));
    ASSERT_TRUE(d);
    EXPECT_NEAR(d->rmse, 0.2, 1e-6);
    EXPECT_NEAR(d->psnr_db, 13.979, 1e-3);  // -20 log10(0.2)
    EXPECT_NEAR(d->max_error, 0.2, 1e-6);
}

TEST(Compare, one_pixel_counts_by_its_share) {
    Image changed = plain(0, {10, 10});
    changed.as<std::uint8_t>()[(5 * 10 + 5) * 3 + 1] = 255;
    const auto d = image::compare(picture(plain(0, {10, 10})), picture(changed));
    ASSERT_TRUE(d);
    EXPECT_NEAR(d->rmse, std::sqrt(1.0 / 300.0), 1e-7);
    EXPECT_EQ(d->max_error, 1.0);
    EXPECT_EQ(d->heat.as<std::uint8_t>()[(5 * 10 + 5) * 3], 255);
}

TEST(Compare, depths_and_channels_may_differ) {
    Image words({32, 24}, 1, Sample::u16);
    std::ranges::fill(words.as<std::uint16_t>(), static_cast<std::uint16_t>(51 * 257));
    const auto d = image::compare(picture(plain(51)), picture(words));
    ASSERT_TRUE(d);
    EXPECT_LT(d->rmse, 1e-7);
}

TEST(Compare, scene_linear_is_clipped_and_encoded) {
    Image linear({32, 24}, 3, Sample::f32);
    std::ranges::fill(linear.as<float>(), math::linear_from_srgb(51.0F / 255.0F));
    const auto same = image::compare(picture(plain(51)), picture(linear, tables::ImageFormat::exr));
    ASSERT_TRUE(same);
    EXPECT_LT(same->rmse, 1e-6);
    std::ranges::fill(linear.as<float>(), 40.0F);
    const auto white =
        image::compare(picture(plain(255)), picture(linear, tables::ImageFormat::hdr));
    ASSERT_TRUE(white);
    EXPECT_LT(white->rmse, 1e-6);
}

TEST(Compare, a_mask_leaves_out_what_either_does_not_cover) {
    Image a = plain(0, {4, 1}, 4), b = plain(0, {4, 1}, 4);
    for (const std::size_t pixel : {0U, 1U}) a.as<std::uint8_t>()[pixel * 4 + 3] = 255;
    for (const std::size_t pixel : {1U, 2U}) b.as<std::uint8_t>()[pixel * 4 + 3] = 255;
    for (std::size_t pixel = 0; pixel < 4; ++pixel) b.as<std::uint8_t>()[pixel * 4] = 255;
    const auto masked =
        image::compare(picture(a), picture(b), {.pixels = image::Pixels::covered, .layer = {}});
    ASSERT_TRUE(masked);
    EXPECT_EQ(masked->pixel_count, 1U);
    EXPECT_NEAR(masked->rmse, std::sqrt(1.0 / 3.0), 1e-7);
    const auto none = image::compare(picture(plain(0, {4, 1}, 4)), picture(b),
                                     {.pixels = image::Pixels::covered, .layer = {}});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, base::ErrorCode::input_invalid);
}

TEST(Compare, different_sizes_are_invalid_input) {
    const auto d = image::compare(picture(plain(0, {4, 4})), picture(plain(0, {4, 5})));
    ASSERT_FALSE(d);
    EXPECT_EQ(d.error().code, base::ErrorCode::input_invalid);
    EXPECT_EQ(d.error().found, "4x4 and 4x5");
}

TEST(Compare, layers_are_compared_by_their_values) {
    Picture a = picture(plain(0, {2, 1})), b = a;
    Image near({2, 1}, 1, Sample::f32), far = near;
    near.as<float>()[0] = far.as<float>()[0] = std::numeric_limits<float>::infinity();
    near.as<float>()[1] = 3.0F;
    far.as<float>()[1] = 5.0F;
    a.layers.push_back({"depth", {"Z"}, near});
    b.layers.push_back({"depth", {"Z"}, far});
    const auto d = image::compare(a, b, {.layer = "depth"});
    ASSERT_TRUE(d);
    EXPECT_EQ(d->max_error, 2.0) << "the same infinity is no difference";
    EXPECT_FALSE(image::compare(a, b, {.layer = "normal"}));
}

TEST(Flip, is_1_at_most_and_larger_for_what_is_larger) {
    const auto flip = [](const Image& a, const Image& b) {
        return image::compare(picture(a), picture(b))->flip.value();
    };
    const double slight = flip(plain(100), plain(104));
    const double clear = flip(plain(100), plain(180));
    EXPECT_GT(slight, 0.0);
    EXPECT_GT(clear, slight);
    EXPECT_LE(flip(plain(0), plain(255)), 1.0);
    EXPECT_GT(flip(plain(0), plain(255)), 0.9);
}

TEST(Flip, of_two_plain_grays_is_the_squeezed_lightness_difference) {
    // No edges, no chroma: CIE L* of sRGB 100 and 180 by hand, then Andersson et al. 2020, 4.1.3.
    const auto lightness = [](double code) {
        const double y = std::pow((code / 255.0 + 0.055) / 1.055, 2.4);
        return 116.0 * std::cbrt(y) - 16.0;
    };
    // The largest distance, green to blue, is 203.3 before the power 0.7 is taken (HyAB of
    // Hunt-adjusted CIELAB).
    const double error = std::pow(lightness(180) - lightness(100), 0.7);
    const auto d = image::compare(picture(plain(100)), picture(plain(180)));
    ASSERT_TRUE(d);
    const double knee = 0.4 * std::pow(203.3, 0.7);
    EXPECT_NEAR(d->flip.value(), error < knee ? 0.95 * error / knee : 0.95, 0.01);
}

/// Radiance of one value, and one pixel of another.
Image radiance(float nit, float lone) {
    Image out({48, 32}, 4, Sample::f32);
    const auto v = out.as<float>();
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = i % 4 == 3 ? 1.0F : nit;
    for (std::size_t c = 0; c < 3; ++c) v[(16 * 48 + 24) * 4 + c] = lone;
    return out;
}

// The curve is 0.85 where 2.51 x^2 + ... is: solved here by bisection, not by the quadratic's
// formula.
TEST(HdrFlip, ExposuresShowTheBrightestAndTheMedianAtEightyFivePercent) {
    const auto stops = flip_exposures(radiance(0.5F, 64.0F));
    ASSERT_EQ(stops.size(), 7U);  // log2(64 / 0.5), a stop apart or less
    float low = 0.0F;
    float high = 100.0F;
    for (int i = 0; i < 60; ++i) {
        const float x = 0.5F * (low + high);
        const float y =
            0.6F * x * (2.51F * 0.6F * x + 0.03F) / (0.6F * x * (2.43F * 0.6F * x + 0.59F) + 0.14F);
        (y < 0.85F ? low : high) = x;
    }
    EXPECT_NEAR(std::exp2(stops.front()) * 64.0F, low, 1e-3F * low);
    EXPECT_NEAR(std::exp2(stops.back()) * 0.5F, low, 1e-3F * low);
}

TEST(HdrFlip, IsZeroForEqualPicturesAndFindsWhatOneExposureHides) {
    const Image a = radiance(0.5F, 64.0F);
    EXPECT_EQ(mean_of(hdr_flip_map(a, a)), 0.0);
    // 64 and 32 nit are both white where 0.5 is exposed for: only a short exposure tells them
    // apart.
    const Image b = radiance(0.5F, 32.0F);
    EXPECT_GT(mean_of(hdr_flip_map(a, b)), 1e-4);
}

TEST(HdrFlip, OfABlackReferenceIsOneWhereTheOtherIsNot) {
    const Image black = radiance(0.0F, 0.0F);
    EXPECT_EQ(mean_of(hdr_flip_map(black, black)), 0.0);
    EXPECT_NEAR(mean_of(hdr_flip_map(black, radiance(0.0F, 1.0F))), 1.0 / (48 * 32), 1e-9);
    EXPECT_TRUE(flip_exposures(black).empty());
}

}  // namespace
}  // namespace facet
