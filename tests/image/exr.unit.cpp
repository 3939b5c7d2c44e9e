// OpenEXR: layers by name, exact numbers, metadata, tiles, odd windows, and what is refused.
// SPDX-License-Identifier: MIT
#include "support/image_samples.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace facet {
namespace {

using image::Depth;
using image::Image;
using image::Layer;
using image::Sample;

class Output : public Imf::OStream {
public:
    Output() : Imf::OStream("test") {}
    void write(const char from[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (at + size > bytes.size()) bytes.resize(at + size);
        std::memcpy(bytes.data() + at, from, size);
        at += size;
    }
    std::uint64_t tellp() override { return at; }
    void seekp(std::uint64_t to) override { at = to; }
    base::Bytes bytes;
    std::size_t at = 0;
};

Layer layer(std::string name, std::vector<std::string> channels, math::Extent size = {9, 5}) {
    const auto count = static_cast<std::uint32_t>(channels.size());
    return {std::move(name), std::move(channels), test::sample_image(size, count, Sample::f32)};
}
image::WriteOptions exr(Depth depth) {
    return {.format = tables::ImageFormat::exr, .depth = depth, .metadata = {}};
}

const Layer* find(const image::Picture& picture, const std::string& name) {
    for (const Layer& one : picture.layers)
        if (one.name == name) return &one;
    return nullptr;
}

TEST(Exr, channels_carry_the_names_that_the_contract_gives_them) {
    const std::vector<Layer> layers{layer("", {"R", "G", "B", "A"}),
                                    layer("normal", {"X", "Y", "Z"}), layer("depth", {"Z"}),
                                    layer("object_id", {"Y"})};
    const auto file = image::encode_exr(layers, exr(Depth::half));
    ASSERT_TRUE(file) << base::to_line(file.error());
    const std::string text(reinterpret_cast<const char*>(file->data()), file->size());
    // As they stand in the file: name, 0, pixel type (1 half, 2 float).
    for (const auto& [name, type] :
         {std::pair{"R", 1}, {"A", 1}, {"normal.X", 1}, {"depth.Z", 2}, {"object_id.Y", 2}})
        EXPECT_NE(
            text.find(std::string(name) + '\0' + static_cast<char>(type) + std::string(3, '\0')),
            std::string::npos)
            << name;
}

TEST(Exr, every_layer_comes_back_with_its_channels_in_order) {
    const std::vector<Layer> layers{layer("", {"R", "G", "B", "A"}),
                                    layer("normal", {"X", "Y", "Z"}),
                                    layer("albedo", {"R", "G", "B"}), layer("depth", {"Z"})};
    const auto file = image::encode_exr(layers, exr(Depth::f32));
    ASSERT_TRUE(file);
    const auto picture = image::decode_picture(*file, base::Limits{});
    ASSERT_TRUE(picture) << base::to_line(picture.error());
    ASSERT_EQ(picture->layers.size(), layers.size());
    for (const Layer& in : layers) {
        const Layer* const out = find(*picture, in.name);
        ASSERT_NE(out, nullptr) << in.name;
        EXPECT_EQ(out->channels, in.channels);
        EXPECT_EQ(out->image.bytes, in.image.bytes) << in.name;
    }
}

TEST(Exr, ids_and_depth_are_exact_though_half_was_asked_for) {
    Layer depth = layer("depth", {"Z"});
    Layer ids = layer("material_id", {"Y"});
    depth.image.as<float>()[0] = std::numeric_limits<float>::infinity();
    depth.image.as<float>()[1] = 1234.5678F;
    for (std::size_t i = 0; i < 45; ++i)
        ids.image.as<float>()[i] = 16777216.0F - static_cast<float>(i);
    const std::vector<Layer> layers{layer("", {"R", "G", "B"}), depth, ids};
    const auto file = image::encode_exr(layers, exr(Depth::half));
    ASSERT_TRUE(file);
    const auto picture = image::decode_picture(*file, base::Limits{});
    ASSERT_TRUE(picture);
    EXPECT_EQ(find(*picture, "depth")->image.bytes, depth.image.bytes);
    EXPECT_EQ(find(*picture, "material_id")->image.bytes, ids.image.bytes);
}

TEST(Exr, what_half_cannot_hold_becomes_its_largest) {
    Layer beauty = layer("", {"R", "G", "B"});
    beauty.image.as<float>()[0] = 1e6F;
    const auto file = image::encode_exr({&beauty, 1}, exr(Depth::half));
    ASSERT_TRUE(file);
    EXPECT_EQ(test::decoded(*file)->as<float>()[0], 65504.0F);
}

TEST(Exr, metadata_are_string_attributes_and_may_not_replace_the_header) {
    const Layer beauty = layer("", {"R", "G", "B"});
    image::WriteOptions options = exr(Depth::half);
    options.metadata = {{"facet", "--size 9x5"}, {"dataWindow", "nonsense"}, {"", "no name"}};
    const auto file = image::encode_exr({&beauty, 1}, options);
    ASSERT_TRUE(file) << base::to_line(file.error());
    const auto picture = image::decode_picture(*file, base::Limits{});
    ASSERT_TRUE(picture);
    ASSERT_EQ(picture->metadata.size(), 1U);
    EXPECT_EQ(picture->metadata[0], std::pair(std::string("facet"), std::string("--size 9x5")));
}

TEST(Exr, nan_infinite_and_negative_pixels_become_0_with_a_count_each) {
    Layer beauty = layer("", {"R", "G", "B"});
    const auto pixels = beauty.image.as<float>();
    pixels[3] = std::numeric_limits<float>::quiet_NaN();
    pixels[4] = -std::numeric_limits<float>::infinity();
    pixels[7] = -2.0F;
    const auto file = image::encode_exr({&beauty, 1}, exr(Depth::f32));
    ASSERT_TRUE(file);
    base::Warnings warnings;
    const auto out = image::decode(*file, base::Limits{}, warnings);
    ASSERT_TRUE(out);
    for (const std::size_t i : {3U, 4U, 7U}) EXPECT_EQ(out->as<float>()[i], 0.0F);
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_EQ(warnings[0].found, "2 values");
    EXPECT_EQ(warnings[1].found, "1 values");
}

TEST(Exr, associated_alpha_is_undone_once_for_textures_and_kept_in_pictures) {
    Layer beauty{"", {"R", "G", "B", "A"}, Image({2, 1}, 4, Sample::f32)};
    const float pixels[8] = {0.1F, 0.2F, 0.25F, 0.5F, 0.3F, 0.0F, 0.0F, 0.0F};
    std::memcpy(beauty.image.bytes.data(), pixels, sizeof pixels);
    const auto file = image::encode_exr({&beauty, 1}, exr(Depth::f32));
    ASSERT_TRUE(file);
    const auto straight = test::decoded(*file);
    ASSERT_TRUE(straight);
    EXPECT_EQ(straight->as<float>()[0], 0.2F);
    EXPECT_EQ(straight->as<float>()[2], 0.5F);
    EXPECT_EQ(straight->as<float>()[4], 0.3F) << "alpha 0 keeps its colour";
    EXPECT_EQ(image::decode_picture(*file, base::Limits{})->layers[0].image.bytes,
              beauty.image.bytes);
}

/// R, G and B floats of 40x20 with the corner at (-3, 7), value x + 100 y + channel.
template <class File>
base::Bytes odd_file(Imf::Header header, const auto& write) {
    const Imath::Box2i window(Imath::V2i(-3, 7), Imath::V2i(36, 26));
    header.dataWindow() = window;
    std::vector<float> pixels(40 * 20 * 3);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = static_cast<float>(i / 3 % 40 + 100 * (i / 120) + i % 3);
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < 3; ++c) {
        const char name[2] = {"RGB"[c], 0};
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, pixels.data() + c, window, 12, 480));
    }
    Output stream;
    {
        File file(stream, header);
        file.setFrameBuffer(buffer);
        write(file);
    }
    return stream.bytes;
}

void expect_odd_picture(const base::Bytes& file) {
    const auto out = test::decoded(file);
    ASSERT_TRUE(out) << base::to_line(out.error());
    ASSERT_EQ(out->size, (math::Extent{40, 20}));
    for (std::size_t i = 0; i < out->sample_count(); ++i)
        ASSERT_EQ(out->as<float>()[i], static_cast<float>(i / 3 % 40 + 100 * (i / 120) + i % 3));
}

TEST(Exr, scanlines_of_every_compression_off_the_origin_are_read) {
    for (const auto compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                   Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
        Imf::Header header(64, 64);
        header.compression() = compression;
        expect_odd_picture(
            odd_file<Imf::OutputFile>(header, [](auto& file) { file.writePixels(20); }));
    }
}

TEST(Exr, tiles_are_read) {
    Imf::Header header(64, 64);
    header.setTileDescription(Imf::TileDescription(16, 8, Imf::ONE_LEVEL));
    expect_odd_picture(odd_file<Imf::TiledOutputFile>(header, [](auto& file) {
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    }));
}

TEST(Exr, a_missing_colour_channel_is_0_with_a_warning) {
    const Layer beauty = layer("", {"R", "B"});
    const auto file = image::encode_exr({&beauty, 1}, exr(Depth::f32));
    ASSERT_TRUE(file);
    base::Warnings warnings;
    const auto out = image::decode(*file, base::Limits{}, warnings);
    ASSERT_TRUE(out);
    ASSERT_EQ(out->channels, 3U);
    EXPECT_EQ(out->as<float>()[0], beauty.image.as<float>()[0]);
    EXPECT_EQ(out->as<float>()[1], 0.0F);
    EXPECT_EQ(out->as<float>()[2], beauty.image.as<float>()[1]);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0].found, "G");
}

TEST(Exr, subsampled_chroma_is_a_missing_feature) {
    Imf::Header header(16, 16);
    header.channels().insert("Y", Imf::Channel(Imf::HALF));
    header.channels().insert("RY", Imf::Channel(Imf::HALF, 2, 2));
    header.channels().insert("BY", Imf::Channel(Imf::HALF, 2, 2));
    Output stream;
    { const Imf::OutputFile file(stream, header); }
    const auto out = image::read_header(stream.bytes, base::Limits{});
    ASSERT_FALSE(out);
    EXPECT_EQ(out.error().code, base::ErrorCode::feature_missing);
}

TEST(Exr, a_header_of_16384_pixels_a_side_without_its_pixels_is_refused_before_memory_is_taken) {
    const Layer beauty = layer("", {"R", "G", "B"});
    auto file = image::encode_exr({&beauty, 1}, exr(Depth::f32));
    ASSERT_TRUE(file);
    const std::string text(reinterpret_cast<const char*>(file->data()), file->size());
    const std::size_t at = text.find("dataWindow") + std::strlen("dataWindow") + 1 + 6 + 4;
    const std::int32_t window[4] = {0, 0, 16383, 16383};
    std::memcpy(file->data() + at, window, sizeof window);
    const auto out = image::read_header(*file, base::Limits{});
    ASSERT_FALSE(out);
    EXPECT_EQ(out.error().code, base::ErrorCode::input_invalid) << base::to_line(out.error());
}

TEST(Exr, layers_of_different_sizes_are_refused) {
    const std::vector<Layer> layers{layer("", {"R", "G", "B"}), layer("depth", {"Z"}, {4, 4})};
    EXPECT_FALSE(image::encode_exr(layers, exr(Depth::half)));
}

}  // namespace
}  // namespace facet
