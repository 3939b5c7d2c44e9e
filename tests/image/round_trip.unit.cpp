// Every format that is written is read back the same, over the table of formats.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "image/read.h"
#include "image/write.h"
#include "support/image_samples.h"
#include "tables/image_formats.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace facet {
namespace {

using image::Depth;
using image::Image;
using image::Sample;

struct Case {
    tables::ImageFormat format{};
    std::string depth;
};

std::vector<Case> cases() {
    std::vector<Case> out;
    for (std::size_t i = 0; i < tables::image_formats.size(); ++i)
        for (const std::string_view depth : base::split(tables::image_formats[i].depths, ','))
            if (tables::image_formats[i].writes)
                out.push_back({static_cast<tables::ImageFormat>(i), std::string(depth)});
    return out;
}

Depth depth_of(const std::string& text) {
    return text == "8"      ? Depth::u8
           : text == "16"   ? Depth::u16
           : text == "half" ? Depth::half
                            : Depth::f32;
}
Sample sample_of(Depth depth) {
    return depth == Depth::u8 ? Sample::u8 : depth == Depth::u16 ? Sample::u16 : Sample::f32;
}

class RoundTrip : public testing::TestWithParam<Case> {
protected:
    Image source(std::uint32_t channels) const {
        Image out = test::sample_image({37, 21}, channels, sample_of(depth_of(GetParam().depth)));
        // decode() makes alpha straight, so associated alpha is kept at 1 to compare colours as
        // they were.
        if (out.sample == Sample::f32 && channels == 4)
            for (std::size_t i = 3; i < out.as<float>().size(); i += 4) out.as<float>()[i] = 1.0F;
        return out;
    }
    image::WriteOptions options() const {
        return {.format = GetParam().format, .depth = depth_of(GetParam().depth), .metadata = {}};
    }
};

double largest_error(const Image& a, const Image& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.sample_count(); ++i) {
        double x = 0.0, y = 0.0;
        if (a.sample == Sample::u8)
            x = a.as<std::uint8_t>()[i], y = b.as<std::uint8_t>()[i];
        else if (a.sample == Sample::u16)
            x = a.as<std::uint16_t>()[i], y = b.as<std::uint16_t>()[i];
        else
            x = static_cast<double>(a.as<float>()[i]), y = static_cast<double>(b.as<float>()[i]);
        largest = std::max(largest, std::fabs(x - y));
    }
    return largest;
}

/// What each format may lose: JPEG a few codes; RGBE 1/128 of a pixel's largest (50); half 2^-11 of
/// it.
double tolerance(const Case& c) {
    switch (c.format) {
        case tables::ImageFormat::jpeg:
            return 24.0;
        case tables::ImageFormat::hdr:
            return 64.0 / 128.0;
        default:
            return c.depth == "half" ? 64.0 / 2048.0 : 0.0;
    }
}

TEST_P(RoundTrip, keeps_the_picture) {
    const bool has_alpha = GetParam().format != tables::ImageFormat::jpeg &&
                           GetParam().format != tables::ImageFormat::hdr;
    for (const std::uint32_t channels : {3U, 4U}) {
        if (channels == 4 && !has_alpha) continue;
        const Image in = source(channels);
        const auto file = image::encode(in, options());
        ASSERT_TRUE(file) << base::to_line(file.error());
        EXPECT_EQ(image::sniff(*file), GetParam().format);
        const auto out = test::decoded(*file);
        ASSERT_TRUE(out) << base::to_line(out.error());
        ASSERT_EQ(out->size, in.size);
        ASSERT_EQ(out->channels, channels);
        ASSERT_EQ(out->sample, in.sample);
        EXPECT_LE(largest_error(in, *out), tolerance(GetParam())) << channels << " channels";
    }
}

TEST_P(RoundTrip, has_the_header_that_its_pixels_have) {
    const auto file = image::encode(source(3), options());
    ASSERT_TRUE(file) << base::to_line(file.error());
    const auto header = image::read_header(*file, base::Limits{});
    ASSERT_TRUE(header) << base::to_line(header.error());
    EXPECT_EQ(header->format, GetParam().format);
    EXPECT_EQ(header->size, (math::Extent{37, 21}));
    EXPECT_EQ(header->channels, 3U);
    EXPECT_EQ(header->sample, sample_of(depth_of(GetParam().depth)));
}

TEST_P(RoundTrip, gives_the_same_bytes_twice) {
    for (const bool fast : {false, true}) {
        image::WriteOptions with = options();
        with.fast = fast;
        with.metadata = {{"Software", "Facet"}};
        const auto first = image::encode(source(3), with);
        const auto second = image::encode(source(3), with);
        ASSERT_TRUE(first && second);
        EXPECT_EQ(*first, *second);
    }
}

TEST_P(RoundTrip, refuses_a_file_cut_anywhere) {
    const auto file = image::encode(source(3), options());
    ASSERT_TRUE(file);
    for (const std::size_t sixteenths : {0U, 1U, 4U, 8U, 12U, 15U}) {
        const auto cut = std::span(*file).first(file->size() * sixteenths / 16);
        EXPECT_FALSE(test::decoded(cut)) << cut.size() << " of " << file->size() << " bytes";
    }
}

TEST_P(RoundTrip, checks_side_area_and_memory_before_the_pixels) {
    const auto file = image::encode(source(3), options());
    ASSERT_TRUE(file);
    base::Limits side, area, memory;
    side.image_side_px = 36;
    area.image_pixels = 37 * 21 - 1;
    memory.memory_bytes = 1000;
    for (const base::Limits& limits : {side, area, memory}) {
        const auto header = image::read_header(*file, limits);
        ASSERT_FALSE(header);
        EXPECT_EQ(header.error().code, base::ErrorCode::limit_reached);
        base::Warnings warnings;
        const auto pixels = image::decode(*file, limits, warnings);
        ASSERT_FALSE(pixels);
        EXPECT_EQ(pixels.error().code, base::ErrorCode::limit_reached);
    }
}

std::string name_of(const testing::TestParamInfo<Case>& row) {
    return std::string(tables::row(row.param.format).key) + "_" + row.param.depth;
}
INSTANTIATE_TEST_SUITE_P(table, RoundTrip, testing::ValuesIn(cases()), name_of);

TEST(Encode, answers_a_second_call_with_another_format) {
    const Image in = test::sample_image({8, 8}, 3, Sample::u8);
    const auto png = image::encode(in, {.format = tables::ImageFormat::png, .metadata = {}});
    const auto jpeg = image::encode(in, {.format = tables::ImageFormat::jpeg, .metadata = {}});
    ASSERT_TRUE(png && jpeg);
    EXPECT_EQ(image::sniff(*png), tables::ImageFormat::png);
    EXPECT_EQ(image::sniff(*jpeg), tables::ImageFormat::jpeg);
}

}  // namespace
}  // namespace facet
