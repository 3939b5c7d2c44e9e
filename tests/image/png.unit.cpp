// PNG: every kind of file is expanded without loss, chunks are as they must be, damage is refused.
// SPDX-License-Identifier: MIT
#include "support/image_png.h"
#include "support/image_samples.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <string>

namespace facet {
namespace {

using image::Image;
using image::Sample;
using test::PngKind;
using test::PngRows;

/// Sample (x, y, channel) of the pictures below, within the bit depth.
std::uint32_t value_at(const PngKind& kind, std::uint32_t x, std::uint32_t y, std::uint32_t c) {
    const std::uint32_t count = 1U << kind.bit_depth;
    return (x * 3 + y * 5 + c * 7) * (kind.bit_depth == 16 ? 257 : 1) % count;
}

std::uint32_t stored_channels(const PngKind& kind) {
    switch (kind.color_type) {
        case PNG_COLOR_TYPE_RGB:
            return 3;
        case PNG_COLOR_TYPE_RGB_ALPHA:
            return 4;
        case PNG_COLOR_TYPE_GRAY_ALPHA:
            return 2;
        default:
            return 1;
    }
}

PngRows rows_of(const PngKind& kind, math::Extent size) {
    const std::uint32_t channels = stored_channels(kind);
    const auto depth = static_cast<std::uint32_t>(kind.bit_depth);
    PngRows rows;
    for (std::uint32_t y = 0; y < size.height; ++y) {
        std::vector<std::uint8_t> row((size.width * channels * depth + 7) / 8);
        for (std::uint32_t i = 0; i < size.width * channels; ++i) {
            const std::uint32_t value = value_at(kind, i / channels, y, i % channels);
            const std::uint32_t bit = i * depth;
            if (depth == 16) {
                row[i * 2] = static_cast<std::uint8_t>(value >> 8);
                row[i * 2 + 1] = static_cast<std::uint8_t>(value);
            } else {
                row[bit / 8] =
                    static_cast<std::uint8_t>(row[bit / 8] | value << (8 - depth - bit % 8));
            }
        }
        rows.push_back(row);
    }
    return rows;
}

/// What decode() must give, sample by sample.
std::uint32_t expected(const PngKind& kind, std::uint32_t x, std::uint32_t y, std::uint32_t c) {
    const std::uint32_t largest = (1U << kind.bit_depth) - 1;
    const std::uint32_t full = kind.bit_depth == 16 ? 65535 : 255;
    if (kind.color_type == PNG_COLOR_TYPE_PALETTE) {
        const std::uint32_t index = value_at(kind, x, y, 0);
        if (c == 3) return index == 0 ? 10 : index == 1 ? 20 : 255;
        return c == 0 ? index : c == 1 ? 255 - index : 3 * index % 256;
    }
    const std::uint32_t colors = stored_channels(kind);
    if (c == colors) {  // made from tRNS: sample value 1 everywhere
        for (std::uint32_t k = 0; k < colors; ++k)
            if (value_at(kind, x, y, k) != 1) return full;
        return 0;
    }
    return value_at(kind, x, y, c) * full / largest;
}

std::vector<PngKind> kinds() {
    std::vector<PngKind> out;
    for (const bool interlaced : {false, true})
        for (const bool transparent : {false, true})
            for (const int type : {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_PALETTE,
                                   PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB_ALPHA})
                for (const int depth : {1, 2, 4, 8, 16}) {
                    const bool has_small =
                        type == PNG_COLOR_TYPE_GRAY || type == PNG_COLOR_TYPE_PALETTE;
                    const bool has_alpha = (type & PNG_COLOR_MASK_ALPHA) != 0;
                    if ((depth < 8 && !has_small) || (has_alpha && transparent)) continue;
                    if (depth == 16 && type == PNG_COLOR_TYPE_PALETTE) continue;
                    out.push_back({type, depth, interlaced, transparent});
                }
    return out;
}

TEST(Png, every_kind_of_file_is_expanded_without_loss) {
    const math::Extent size{23, 11};
    for (const PngKind& kind : kinds()) {
        SCOPED_TRACE(testing::Message()
                     << "type " << kind.color_type << ", " << kind.bit_depth << " bits, interlaced "
                     << kind.interlaced << ", tRNS " << kind.has_transparency);
        const auto file = test::write_png_kind(kind, size, rows_of(kind, size));
        const auto out = test::decoded(file);
        ASSERT_TRUE(out) << base::to_line(out.error());
        const std::uint32_t colors =
            kind.color_type == PNG_COLOR_TYPE_PALETTE ? 3 : stored_channels(kind);
        ASSERT_EQ(out->channels, colors + (kind.has_transparency ? 1 : 0));
        ASSERT_EQ(out->sample, kind.bit_depth == 16 ? Sample::u16 : Sample::u8);
        const auto header = image::read_header(file, base::Limits{});
        ASSERT_TRUE(header);
        EXPECT_EQ(header->channels, out->channels);
        EXPECT_EQ(header->sample, out->sample);
        for (std::size_t i = 0; i < out->sample_count(); ++i) {
            const auto c = static_cast<std::uint32_t>(i % out->channels);
            const auto x = static_cast<std::uint32_t>(i / out->channels % size.width);
            const auto y = static_cast<std::uint32_t>(i / out->channels / size.width);
            const std::uint32_t got = out->sample == Sample::u16 ? out->as<std::uint16_t>()[i]
                                                                 : out->as<std::uint8_t>()[i];
            ASSERT_EQ(got, expected(kind, x, y, c)) << x << ' ' << y << ' ' << c;
        }
    }
}

TEST(Png, has_one_sRGB_chunk_before_the_pixels) {
    for (const bool fast : {false, true}) {
        const auto file = image::encode(test::sample_image({5, 4}, 3, Sample::u8),
                                        {.metadata = {}, .fast = fast});
        ASSERT_TRUE(file);
        const std::string text(reinterpret_cast<const char*>(file->data()), file->size());
        const std::string chunk("\0\0\0\1sRGB\0\xAE\xCE\x1C\xE9", 13);  // with its checksum
        EXPECT_NE(text.find(chunk), std::string::npos);
        EXPECT_LT(text.find(chunk), text.find("IDAT"));
    }
}

TEST(Png, metadata_come_back_ascii_and_utf8) {
    const std::vector<std::pair<std::string, std::string>> metadata{
        {"facet:settings", "{\"size\":[5,4]}"}, {"Title", "Шлем"}, {"Empty", ""}};
    const auto file =
        image::encode(test::sample_image({5, 4}, 4, Sample::u8), {.metadata = metadata});
    ASSERT_TRUE(file);
    const auto picture = image::decode_picture(*file, base::Limits{});
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->metadata, metadata);
}

TEST(Png, a_flipped_bit_in_the_pixels_is_an_error_with_its_offset) {
    auto file = image::encode(test::sample_image({50, 40}, 3, Sample::u8), {.metadata = {}});
    ASSERT_TRUE(file);
    (*file)[file->size() / 2] ^= std::byte{4};
    const auto out = test::decoded(*file);
    ASSERT_FALSE(out);
    EXPECT_EQ(out.error().code, base::ErrorCode::input_invalid);
    EXPECT_EQ(out.error().where.substr(0, 3), "@0x");
}

TEST(Png, sixteen_bits_round_to_eight_and_back_without_loss) {
    const Image in = test::sample_image({64, 64}, 4, Sample::u8);
    const auto wide = image::encode(in, {.depth = image::Depth::u16, .metadata = {}});
    ASSERT_TRUE(wide);
    const auto words = test::decoded(*wide);
    ASSERT_TRUE(words);
    ASSERT_EQ(words->sample, Sample::u16);
    const auto narrow = image::encode(*words, {.depth = image::Depth::u8, .metadata = {}});
    ASSERT_TRUE(narrow);
    const auto out = test::decoded(*narrow);
    ASSERT_TRUE(out);
    EXPECT_EQ(out->bytes, in.bytes);
}

TEST(Png, a_header_of_100000_pixels_a_side_is_refused_by_the_limit) {
    auto file = image::encode(test::sample_image({5, 4}, 3, Sample::u8), {.metadata = {}});
    ASSERT_TRUE(file);
    const auto put = [&](std::size_t at, std::uint32_t number) {
        for (std::size_t i = 0; i < 4; ++i)
            (*file)[at + i] = static_cast<std::byte>(number >> (24 - 8 * i));
    };
    put(16, 100000);
    put(20, 100000);
    EXPECT_EQ(test::decoded(*file).error().code, base::ErrorCode::input_invalid) << "checksum";
    put(29, libdeflate_crc32(0, file->data() + 12, 17));
    EXPECT_EQ(test::decoded(*file).error().code, base::ErrorCode::limit_reached);
}

TEST(Png, pixels_that_unpack_to_more_than_the_header_says_stop_there) {
    // The rows of 64x64 behind the header of 64x4: what libpng too gives up on or cuts, never more
    // memory.
    auto file = image::encode(test::sample_image({64, 64}, 3, Sample::u8), {.metadata = {}});
    ASSERT_TRUE(file);
    (*file)[23] = std::byte{4};
    const std::uint32_t crc = libdeflate_crc32(0, file->data() + 12, 17);
    for (std::size_t i = 0; i < 4; ++i)
        (*file)[29 + i] = static_cast<std::byte>(crc >> (24 - 8 * i));
    const auto out = test::decoded(*file);
    if (out) {
        EXPECT_EQ(out->bytes.size(), 64U * 4 * 3);
    } else {
        EXPECT_EQ(out.error().code, base::ErrorCode::input_invalid);
    }
}

TEST(Png, floating_point_pixels_are_not_taken_silently) {
    EXPECT_FALSE(image::encode(test::sample_image({5, 4}, 3, Sample::f32), {.metadata = {}}));
}

}  // namespace
}  // namespace facet
