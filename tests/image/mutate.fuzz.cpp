// Damaged pictures of every format: each decode must return, whatever bytes it is given.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "image/read.h"
#include "support/image_png.h"
#include "support/image_samples.h"
#include "tables/image_formats.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <algorithm>
#include <random>
#include <string>

namespace facet {
namespace {

using image::Sample;

/// Low, so that a header made huge by chance costs a refusal and not the machine's memory.
base::Limits small_limits() {
    base::Limits limits;
    limits.image_side_px = 2048;
    limits.image_pixels = 1 << 20;
    limits.memory_bytes = 64 << 20;
    return limits;
}

/// Overwrites, flips, cuts, repeats: 1 to 8 changes, half of them in the first 256 bytes.
base::Bytes damaged(base::Bytes bytes, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    const std::size_t changes = 1 + below(8);
    for (std::size_t i = 0; i < changes && bytes.size() > 8; ++i) {
        const std::size_t range =
            below(2) == 0 ? std::min<std::size_t>(256, bytes.size()) : bytes.size();
        // The magic stays, or nothing is decoded at all.
        const std::size_t at = std::min<std::size_t>(4 + below(range), bytes.size() - 1);
        constexpr std::uint8_t odd[] = {0, 1, 127, 128, 255};
        switch (below(6)) {
            case 0:
                bytes[at] = static_cast<std::byte>(below(256));
                break;
            case 1:
                bytes[at] ^= static_cast<std::byte>(1U << below(8));
                break;
            case 2:
                bytes[at] = static_cast<std::byte>(odd[below(5)]);
                break;
            case 3:
                bytes.resize(at);
                break;
            case 4:
                bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                             static_cast<std::byte>(below(256)));
                break;
            default:
                for (std::size_t k = at; k < std::min(at + 4, bytes.size()); ++k)
                    bytes[k] = static_cast<std::byte>(odd[below(5)]);
        }
    }
    return bytes;
}

void decode_all_ways(const base::Bytes& file) {
    const base::Limits limits = small_limits();
    base::Warnings warnings;
    const auto header = image::read_header(file, limits);
    const auto pixels = image::decode(file, limits, warnings);
    const auto picture = image::decode_picture(file, limits);
    if (pixels) {
        EXPECT_EQ(pixels->bytes.size(),
                  pixels->sample_count() * image::sample_bytes(pixels->sample));
        EXPECT_LE(pixels->size.pixels(), limits.image_pixels);
        EXPECT_TRUE(header) << "pixels without a header";
    } else {
        EXPECT_FALSE(pixels.error().what.empty());
        EXPECT_NE(pixels.error().code, base::ErrorCode::internal) << base::to_line(pixels.error());
    }
    if (picture) {
        EXPECT_FALSE(picture->layers.empty());
    }
}

void fuzz(const base::Bytes& seed, int rounds) {
    std::mt19937 random(20240229);
    for (int round = 0; round < rounds; ++round) decode_all_ways(damaged(seed, random));
}

TEST(MutatedPictures, of_every_format_return) {
    for (std::size_t i = 0; i < tables::image_formats.size(); ++i) {
        const auto& row = tables::image_formats[i];
        SCOPED_TRACE(std::string(row.key));
        const Sample sample = row.scene_linear ? Sample::f32 : Sample::u8;
        for (const bool fast : {false, true}) {
            image::WriteOptions options{
                .format = static_cast<tables::ImageFormat>(i),
                .depth = row.scene_linear ? image::Depth::f32 : image::Depth::u8,
                .metadata = {{"Software", "Facet"}},
                .fast = fast};
            const std::uint32_t channels = row.scene_linear || !fast ? 3 : 4;
            const auto seed =
                image::encode(test::sample_image({24, 17}, channels, sample), options);
            ASSERT_TRUE(seed) << base::to_line(seed.error());
            // libtiff behind OpenImageIO takes 30 times as long to open a file.
            fuzz(*seed, row.slow_module ? 100 : 1500);
        }
    }
}

TEST(MutatedPictures, of_png_kinds_that_libpng_reads_return) {
    for (const int type : {PNG_COLOR_TYPE_PALETTE, PNG_COLOR_TYPE_GRAY}) {
        const test::PngKind kind{type, 4, true, true};
        test::PngRows rows(17, std::vector<std::uint8_t>(12, 0x31));
        fuzz(test::write_png_kind(kind, {24, 17}, rows), 1500);
    }
}

/// Every checksum made to hold, as far as the chunks can be followed.
void mend_checksums(base::Bytes& file) {
    for (std::size_t at = 8; at + 12 <= file.size();) {
        const auto big = [&](std::size_t k) { return std::to_integer<std::size_t>(file[at + k]); };
        const std::size_t length = big(0) << 24 | big(1) << 16 | big(2) << 8 | big(3);
        if (length > file.size() - at - 12) return;
        const std::uint32_t crc = libdeflate_crc32(0, file.data() + at + 4, length + 4);
        for (std::size_t i = 0; i < 4; ++i)
            file[at + 8 + length + i] = static_cast<std::byte>(crc >> (24 - 8 * i));
        at += 12 + length;
    }
}

TEST(MutatedPictures, png_with_checksums_that_hold_return) {
    // The damage reaches the code behind the checksums: ours for the plain file, libpng's for the
    // other.
    const auto plain = image::encode(test::sample_image({24, 17}, 3, Sample::u8), {.metadata = {}});
    ASSERT_TRUE(plain);
    const test::PngKind kind{PNG_COLOR_TYPE_PALETTE, 4, true, true};
    const test::PngRows rows(17, std::vector<std::uint8_t>(12, 0x31));
    const base::Bytes palette = test::write_png_kind(kind, {24, 17}, rows);
    std::mt19937 random(5);
    for (int round = 0; round < 4000; ++round) {
        base::Bytes file = round % 2 == 0 ? *plain : palette;
        const std::size_t in_header = 16 + random() % 13;
        if (random() % 2 == 0) file[in_header] = static_cast<std::byte>(random());
        const std::size_t behind = 33 + random() % (file.size() - 33);
        file[behind] = static_cast<std::byte>(random());
        mend_checksums(file);
        decode_all_ways(file);
    }
}

TEST(RandomBytes, behind_a_magic_return) {
    std::mt19937 random(99);
    for (const std::string& magic :
         {std::string("\x89PNG\r\n\x1A\n"), std::string("\xFF\xD8\xFF\xE0"),
          std::string("RIFF\x40\0\0\0WEBPVP8L", 16),
          std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 8\n"),
          std::string("\x76\x2F\x31\x01\2\0\0\0", 8)})
        for (int round = 0; round < 500; ++round) {
            base::Bytes file = test::bytes_of(magic);
            for (std::size_t i = random() % 200; i > 0; --i)
                file.push_back(static_cast<std::byte>(random()));
            decode_all_ways(file);
        }
}

}  // namespace
}  // namespace facet
