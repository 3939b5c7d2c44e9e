// Size limits and shared errors of the picture readers.
// SPDX-License-Identifier: MIT
#include "image/checks.h"

#include <spdlog/fmt/fmt.h>

#include <utility>

namespace facet::image {

base::Status check_size(const StatedSize& size, std::uint64_t bytes_per_pixel,
                        const base::Limits& limits) {
    const std::string found = fmt::format("{}x{}", size.width, size.height);
    if (size.width == 0 || size.height == 0)
        return base::fail({.code = base::ErrorCode::input_invalid,
                           .where = "header",
                           .what = "the picture has no pixels",
                           .found = found,
                           .remedy = "export it again"});
    if (size.width > limits.image_side_px || size.height > limits.image_side_px)
        return base::fail({.code = base::ErrorCode::limit_reached,
                           .where = "header",
                           .what = fmt::format("a side over {} pixels", limits.image_side_px),
                           .found = found,
                           .remedy = "scale the picture down"});
    // Both sides fit 32 bits from here on, so the product fits 64.
    const std::uint64_t pixels = size.width * size.height;
    if (pixels > limits.image_pixels)
        return base::fail({.code = base::ErrorCode::limit_reached,
                           .where = "header",
                           .what = fmt::format("more than {} pixels", limits.image_pixels),
                           .found = found,
                           .remedy = "scale the picture down"});
    if (bytes_per_pixel != 0 && pixels > limits.memory_bytes / bytes_per_pixel)
        return base::fail(
            {.code = base::ErrorCode::limit_reached,
             .where = "header",
             .what = fmt::format("decoding needs more than {} MiB", limits.memory_bytes >> 20),
             .found = fmt::format("{}, {} bytes a pixel", found, bytes_per_pixel),
             .remedy = "raise --max-memory, or scale the picture down"});
    return {};
}

tl::unexpected<base::Error> damaged(std::size_t offset, std::string what, std::string found) {
    return base::fail({.code = base::ErrorCode::input_invalid,
                       .where = fmt::format("@{:#x}", offset),
                       .what = std::move(what),
                       .found = std::move(found),
                       .remedy = "export the picture again"});
}

tl::unexpected<base::Error> unsupported(std::string what, std::string found) {
    return base::fail({.code = base::ErrorCode::feature_missing,
                       .where = "header",
                       .what = std::move(what),
                       .found = std::move(found),
                       .remedy = "convert the picture"});
}

Picture one_layer(tables::ImageFormat format, Image image) {
    Picture picture;
    picture.format = format;
    Layer layer;
    switch (image.channels) {
        case 1:
            layer.channels = {"Y"};
            break;
        case 2:
            layer.channels = {"Y", "A"};
            break;
        case 3:
            layer.channels = {"R", "G", "B"};
            break;
        default:
            layer.channels = {"R", "G", "B", "A"};
            break;
    }
    layer.image = std::move(image);
    picture.layers.push_back(std::move(layer));
    return picture;
}

base::Result<Image> with_integer_depth(const Image& image, Sample sample) {
    if (image.sample == Sample::f32 || sample == Sample::f32)
        return base::fail({.code = base::ErrorCode::internal,
                           .what = "an integer picture was asked for from floating-point pixels"});
    if (image.sample == sample) return image;
    Image out(image.size, image.channels, sample);
    const std::size_t count = image.sample_count();
    if (sample == Sample::u8) {
        const auto in = image.as<std::uint16_t>();
        const auto to = out.as<std::uint8_t>();
        // round(v / 257) without a division: exact for all 65536 values.
        for (std::size_t i = 0; i < count; ++i)
            to[i] = static_cast<std::uint8_t>((std::uint32_t{in[i]} * 255U + 32895U) >> 16);
    } else {
        const auto in = image.as<std::uint8_t>();
        const auto to = out.as<std::uint16_t>();
        for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::uint16_t>(in[i] * 257);
    }
    return out;
}

bool names_srgb(std::string_view icc_profile) {
    using namespace std::string_view_literals;
    return icc_profile.find("sRGB") != std::string_view::npos ||
           icc_profile.find("s\0R\0G\0B"sv) != std::string_view::npos;
}

base::Warning foreign_color_space(std::string found) {
    return {.file = {},
            .where = "header",
            .what = "the colours are not in sRGB and are used as if they were",
            .found = std::move(found),
            .remedy = "convert the picture to sRGB"};
}

}  // namespace facet::image
