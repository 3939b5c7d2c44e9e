// Radiance pictures: run lengths new and old, axes in any order, exposure, and what is refused.
// SPDX-License-Identifier: MIT
#include "support/image_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace facet {
namespace {

using image::Image;

/// A file of flat or old-run pixels; `body` is raw RGBE.
base::Bytes hdr(const std::string& header, const std::string& resolution, const std::string& body) {
    return test::bytes_of("#?RADIANCE\n" + header + "\n" + resolution + "\n" + body);
}
const std::string format = "FORMAT=32-bit_rle_rgbe\n";
/// 128 * 2^(129 - 136) = 1 in one channel.
const std::string red("\x80\0\0\x81", 4), green("\0\x80\0\x81", 4), blue("\0\0\x80\x81", 4);

std::vector<float> values(const base::Result<Image>& image) {
    if (!image) return {};
    const auto v = image->as<float>();
    return {v.begin(), v.end()};
}
/// The colours of the pixels as letters.
std::string letters(const base::Result<Image>& image) {
    if (!image) return base::to_line(image.error());
    std::string out;
    const auto v = image->as<float>();
    for (std::size_t i = 0; i < v.size(); i += 3)
        out += v[i] == 1.0F ? 'r' : v[i + 1] == 1.0F ? 'g' : v[i + 2] == 1.0F ? 'b' : '?';
    return out;
}

TEST(Hdr, a_mantissa_of_128_and_exponent_of_129_is_1) {
    EXPECT_EQ(letters(test::decoded(hdr(format, "-Y 1 +X 3", red + green + blue))), "rgb");
}

TEST(Hdr, axes_put_the_first_pixel_where_they_say) {
    const std::string six = red + red + green + green + blue + blue;  // as stored
    const auto shown = [&](const char* resolution) {
        return letters(test::decoded(hdr(format, resolution, six)));
    };
    EXPECT_EQ(shown("-Y 2 +X 3"),
              "rrg"
              "gbb");
    EXPECT_EQ(shown("-Y 2 -X 3"),
              "grr"
              "bbg");
    EXPECT_EQ(shown("+Y 2 +X 3"),
              "gbb"
              "rrg");
    EXPECT_EQ(shown("+Y 2 -X 3"),
              "bbg"
              "grr");
    EXPECT_EQ(shown("+X 3 -Y 2"),
              "rgb"
              "rgb");  // columns from the left, each from the top
    EXPECT_EQ(shown("-X 3 -Y 2"),
              "bgr"
              "bgr");
    EXPECT_EQ(shown("+X 2 -Y 3"),
              "rg"
              "rb"
              "gb");
    EXPECT_EQ(shown("+X 2 +Y 3"),
              "gb"
              "rb"
              "rg");
}

TEST(Hdr, exposures_multiply_and_are_undone) {
    const auto image = test::decoded(hdr(format + "EXPOSURE=2\nEXPOSURE= 4.0\n", "-Y 1 +X 1", red));
    EXPECT_EQ(values(image), (std::vector<float>{0.125F, 0.0F, 0.0F}));
    const auto corrected = test::decoded(hdr(format + "COLORCORR=2 1 1\n", "-Y 1 +X 1", red));
    EXPECT_EQ(values(corrected), (std::vector<float>{0.5F, 0.0F, 0.0F}));
}

TEST(Hdr, old_runs_repeat_the_pixel_before_with_counts_of_base_256) {
    const std::string twice("\1\1\1\2", 4), none("\1\1\1\0", 4), one_high("\1\1\1\1", 4);
    EXPECT_EQ(letters(test::decoded(hdr(format, "-Y 1 +X 4", red + twice + green))), "rrrg");
    const auto long_run =
        letters(test::decoded(hdr(format, "-Y 1 +X 258", red + none + one_high + blue)));
    EXPECT_EQ(long_run, std::string(257, 'r') + "b");
}

TEST(Hdr, new_runs_are_read_by_channel) {
    // 8 pixels: R is a run of 8 x 128, G literal zeros, B a run of zeros, E a run of 129.
    const std::string scanline = std::string("\2\2\0\x08", 4) + "\x88\x80" +
                                 std::string("\x08\0\0\0\0\0\0\0\0", 9) + std::string("\x88\0", 2) +
                                 "\x88\x81";
    EXPECT_EQ(letters(test::decoded(hdr(format, "-Y 1 +X 8", scanline))), "rrrrrrrr");
}

void expect_refused(const base::Bytes& file, base::ErrorCode code) {
    const auto out = test::decoded(file);
    ASSERT_FALSE(out);
    EXPECT_EQ(out.error().code, code) << base::to_line(out.error());
    EXPECT_FALSE(out.error().where.empty());
}

TEST(Hdr, what_is_wrong_is_refused_with_its_place) {
    using base::ErrorCode;
    const std::string start("\2\2\0\x08", 4);
    expect_refused(hdr("", "-Y 1 +X 1", red), ErrorCode::input_invalid);
    expect_refused(hdr("FORMAT=cheese\n", "-Y 1 +X 1", red), ErrorCode::input_invalid);
    expect_refused(hdr("FORMAT=32-bit_rle_xyze\n", "-Y 1 +X 1", red), ErrorCode::feature_missing);
    expect_refused(hdr(format + "EXPOSURE=0\n", "-Y 1 +X 1", red), ErrorCode::input_invalid);
    expect_refused(hdr(format + "EXPOSURE=nan\n", "-Y 1 +X 1", red), ErrorCode::input_invalid);
    expect_refused(hdr(format, "-Y 1", red), ErrorCode::input_invalid);
    expect_refused(hdr(format, "-Y 1 -Y 1", red), ErrorCode::input_invalid);
    expect_refused(hdr(format, "-Y -1 +X 1", red), ErrorCode::input_invalid);
    expect_refused(hdr(format, "-Y 0 +X 1", red), ErrorCode::input_invalid);
    expect_refused(hdr(format, "-Y 99999999999999999999 +X 1", red), ErrorCode::input_invalid);
    expect_refused(hdr(format, "-Y 100000 +X 100000", red), ErrorCode::limit_reached);
    expect_refused(hdr(format, "-Y 16384 +X 16384", red), ErrorCode::input_invalid);
    expect_refused(hdr(format, "-Y 1 +X 8", start + "\x89\x80"), ErrorCode::input_invalid);
    expect_refused(hdr(format, "-Y 1 +X 8", start + std::string("\0\x80", 2)),
                   ErrorCode::input_invalid);
    expect_refused(hdr(format, "-Y 1 +X 9", start + "\x88\x80"), ErrorCode::input_invalid);
    expect_refused(hdr(format, "-Y 1 +X 4", std::string("\1\1\1\2", 4) + red),
                   ErrorCode::input_invalid);
    expect_refused(hdr(format, "-Y 1 +X 4", red + std::string("\1\1\1\4", 4)),
                   ErrorCode::input_invalid);
}

TEST(Hdr, an_error_names_the_offset_of_the_bad_run) {
    const std::string start("\2\2\0\x08", 4);
    const auto file = hdr(format, "-Y 1 +X 8", start + "\x89\x80");
    const auto out = test::decoded(file);
    ASSERT_FALSE(out);
    EXPECT_EQ(std::stoul(out.error().where.substr(1), nullptr, 16), file.size() - 2);
}

TEST(Hdr, encoded_values_keep_a_precision_of_one_part_in_128_of_the_largest_channel) {
    Image in(math::Extent{16, 1}, 3, image::Sample::f32);
    for (std::size_t i = 0; i < 48; ++i)
        in.as<float>()[i] =
            std::ldexp(1.0F + static_cast<float>(i) / 50.0F, static_cast<int>(i) * 4 - 96);
    in.as<float>()[0] = -1.0F;  // RGBE has no sign
    const auto file = image::encode(in, {.format = tables::ImageFormat::hdr, .metadata = {}});
    ASSERT_TRUE(file);
    const auto out = test::decoded(*file);
    ASSERT_TRUE(out);
    EXPECT_EQ(out->as<float>()[0], 0.0F);
    for (std::size_t p = 0; p < 16; ++p) {
        const float largest = in.as<float>()[p * 3 + 2];
        for (std::size_t c = p == 0 ? 1 : 0; c < 3; ++c)
            EXPECT_NEAR(out->as<float>()[p * 3 + c], in.as<float>()[p * 3 + c], largest / 128.0F);
    }
}

}  // namespace
}  // namespace facet
