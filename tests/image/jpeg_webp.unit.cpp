// JPEG and WebP: CMYK, gray, progressive, alpha over black, animations.
// SPDX-License-Identifier: MIT
#include "image/bytes.h"
#include "image/libjpeg.h"
#include "support/image_samples.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace facet {
namespace {

using image::Image;
using image::Sample;

/// One colour of 16x8 pixels in any of libjpeg's colour spaces.
base::Bytes plain_jpeg(J_COLOR_SPACE in, J_COLOR_SPACE stored, std::vector<std::uint8_t> color,
                       bool progressive) {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char* bytes = nullptr;
    unsigned long count = 0;
    jpeg_mem_dest(&info, &bytes, &count);
    info.image_width = 16;
    info.image_height = 8;
    info.input_components = static_cast<int>(color.size());
    info.in_color_space = in;
    jpeg_set_defaults(&info);
    jpeg_set_colorspace(&info, stored);
    jpeg_set_quality(&info, 100, TRUE);
    if (progressive) jpeg_simple_progression(&info);
    jpeg_start_compress(&info, TRUE);
    std::vector<std::uint8_t> row;
    for (int x = 0; x < 16; ++x) row.insert(row.end(), color.begin(), color.end());
    while (info.next_scanline < info.image_height) {
        JSAMPROW pointer = row.data();
        jpeg_write_scanlines(&info, &pointer, 1);
    }
    jpeg_finish_compress(&info);
    jpeg_destroy_compress(&info);
    base::Bytes out;
    image::append(out, std::as_bytes(std::span(bytes, count)));
    std::free(bytes);
    return out;
}

TEST(Jpeg, cmyk_and_ycck_become_rgb_with_a_warning) {
    // Adobe's, as libjpeg writes it, is inverted: 255 is no ink. Half cyan ink, no key.
    for (const J_COLOR_SPACE stored : {JCS_CMYK, JCS_YCCK}) {
        base::Warnings warnings;
        const auto file = plain_jpeg(JCS_CMYK, stored, {128, 255, 255, 255}, false);
        const auto out = image::decode(file, base::Limits{}, warnings);
        ASSERT_TRUE(out) << base::to_line(out.error());
        ASSERT_EQ(out->channels, 3U);
        EXPECT_NEAR(out->as<std::uint8_t>()[0], 128, 2);
        EXPECT_NEAR(out->as<std::uint8_t>()[1], 255, 2);
        EXPECT_NEAR(out->as<std::uint8_t>()[2], 255, 2);
        EXPECT_EQ(warnings.size(), 1U);
    }
}

TEST(Jpeg, gray_stays_one_channel_and_progressive_is_read) {
    const auto gray = test::decoded(plain_jpeg(JCS_GRAYSCALE, JCS_GRAYSCALE, {77}, false));
    ASSERT_TRUE(gray);
    EXPECT_EQ(gray->channels, 1U);
    EXPECT_EQ(gray->as<std::uint8_t>()[5], 77);
    const auto color = test::decoded(plain_jpeg(JCS_RGB, JCS_YCbCr, {200, 100, 50}, true));
    ASSERT_TRUE(color);
    ASSERT_EQ(color->channels, 3U);
    EXPECT_NEAR(color->as<std::uint8_t>()[0], 200, 2);
    EXPECT_NEAR(color->as<std::uint8_t>()[2], 50, 2);
}

TEST(Jpeg, twelve_bits_are_a_missing_feature_and_no_size_is_invalid) {
    auto file = plain_jpeg(JCS_GRAYSCALE, JCS_GRAYSCALE, {77}, false);
    const std::string text(reinterpret_cast<const char*>(file.data()), file.size());
    const std::size_t frame = text.find("\xFF\xC0");
    ASSERT_NE(frame, std::string::npos);
    auto deep = file;
    deep[frame + 4] = std::byte{12};
    EXPECT_EQ(test::decoded(deep).error().code, base::ErrorCode::feature_missing);
    auto empty = file;
    empty[frame + 7] = empty[frame + 8] = std::byte{0};
    EXPECT_EQ(test::decoded(empty).error().code, base::ErrorCode::input_invalid);
    auto huge = file;
    for (const std::size_t at : {5U, 7U}) huge[frame + at] = std::byte{0xFF};
    EXPECT_EQ(test::decoded(huge).error().code, base::ErrorCode::limit_reached);
}

TEST(Jpeg, alpha_is_laid_over_black) {
    Image in({8, 8}, 4, Sample::u8);
    for (std::size_t i = 0; i < in.bytes.size(); ++i)
        in.as<std::uint8_t>()[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 128 : 200);
    const auto file = image::encode(in, {.format = tables::ImageFormat::jpeg, .metadata = {}});
    ASSERT_TRUE(file);
    const auto out = test::decoded(*file);
    ASSERT_TRUE(out);
    EXPECT_NEAR(out->as<std::uint8_t>()[0], 100, 2);
}

void append_chunk(base::Bytes& out, std::string_view type, std::span<const std::byte> body) {
    image::append(out, type);
    image::append_little32(out, static_cast<std::uint32_t>(body.size()));
    image::append(out, body);
    if (body.size() % 2 != 0) out.push_back(std::byte{0});
}

/// `frame`, a still lossless WebP of 8x6, shown twice at (4, 2) of a canvas of 16x12.
base::Bytes animated(std::span<const std::byte> frame) {
    const auto number = [](base::Bytes& out, std::uint64_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::byte>(value >> (8 * i)));
    };
    base::Bytes canvas, loop, one, chunks, out;
    number(canvas, 0x12, 4);  // alpha, animation
    number(canvas, 15, 3);
    number(canvas, 11, 3);
    number(loop, 0, 6);
    for (const std::uint32_t value : {2U, 1U, 7U, 5U, 100U})
        number(one, value, 3);  // halves of the offset
    number(one, 0, 1);
    image::append(one, frame.subspan(12));  // the chunks behind RIFF, size, WEBP
    image::append(chunks, "WEBP");
    append_chunk(chunks, "VP8X", canvas);
    append_chunk(chunks, "ANIM", loop);
    append_chunk(chunks, "ANMF", one);
    append_chunk(chunks, "ANMF", one);
    append_chunk(out, "RIFF", chunks);
    return out;
}

TEST(Webp, the_first_frame_of_an_animation_lies_on_its_canvas_with_a_warning) {
    const Image frame = test::sample_image({8, 6}, 4, Sample::u8);
    const auto still = image::encode(frame, {.format = tables::ImageFormat::webp, .metadata = {}});
    ASSERT_TRUE(still);
    base::Warnings warnings;
    const auto out = image::decode(animated(*still), base::Limits{}, warnings);
    ASSERT_TRUE(out) << base::to_line(out.error());
    EXPECT_EQ(warnings.size(), 1U);
    ASSERT_EQ(out->size, (math::Extent{16, 12}));
    EXPECT_EQ(out->as<std::uint8_t>()[3], 0) << "transparent outside";
    const std::size_t inside = ((2 + 3) * 16 + 4 + 5) * 4;
    for (std::size_t c = 0; c < 4; ++c)
        EXPECT_EQ(out->as<std::uint8_t>()[inside + c],
                  frame.as<std::uint8_t>()[(3 * 8 + 5) * 4 + c]);
}

TEST(Webp, colour_beneath_alpha_0_is_kept) {
    Image in({4, 4}, 4, Sample::u8);
    for (std::size_t i = 0; i < 64; i += 4) in.as<std::uint8_t>()[i] = 99;
    const auto file = image::encode(in, {.format = tables::ImageFormat::webp, .metadata = {}});
    ASSERT_TRUE(file);
    EXPECT_EQ(test::decoded(*file)->bytes, in.bytes);
}

}  // namespace
}  // namespace facet
