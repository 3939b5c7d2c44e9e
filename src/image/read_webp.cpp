// Reads WebP through libwebp: lossy and lossless, and the first frame of an animation.
// SPDX-License-Identifier: MIT
#include "image/bytes.h"
#include "image/checks.h"
#include "image/dispatch.h"
#include "image/webp_chunks.h"

#include <spdlog/fmt/fmt.h>
#include <webp/decode.h>

#include <cstring>
#include <string>
#include <utility>

namespace facet::image::webp {
namespace {

const std::uint8_t* raw(FileBytes file) {
    return reinterpret_cast<const std::uint8_t*>(file.data());
}

base::Result<WebPBitstreamFeatures> features_of(FileBytes file) {
    WebPBitstreamFeatures features{};
    switch (WebPGetFeatures(raw(file), file.size(), &features)) {
        case VP8_STATUS_OK:
            return features;
        case VP8_STATUS_NOT_ENOUGH_DATA:
            return damaged(file.size(), "the file is cut short");
        default:
            return damaged(0, "the WebP header is damaged");
    }
}

base::Result<Header> header_of(const WebPBitstreamFeatures& features, const base::Limits& limits) {
    const StatedSize size{static_cast<std::uint64_t>(features.width),
                          static_cast<std::uint64_t>(features.height)};
    // Lossless decoding holds ARGB beside the result.
    if (auto checked = check_size(size, 8, limits); !checked)
        return tl::unexpected(checked.error());
    return Header{tables::ImageFormat::webp,
                  {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)},
                  features.has_alpha != 0 ? 4U : 3U,
                  Sample::u8};
}

base::Result<Image> pixels_of(FileBytes file, const Header& header) {
    Image image(header.size, header.channels, Sample::u8);
    const auto stride = static_cast<int>(header.size.width * header.channels);
    const auto decode = header.channels == 4 ? WebPDecodeRGBAInto : WebPDecodeRGBInto;
    if (decode(raw(file), file.size(), image.as<std::uint8_t>().data(), image.bytes.size(),
               stride) == nullptr)
        return damaged(file.size(), "the WebP's pixels are damaged or cut short");
    return image;
}

/// The frame on its canvas, which is transparent around it.
base::Result<Image> on_canvas(Image frame, const FirstFrame& place) {
    if (frame.size == place.canvas) return frame;
    if (place.x > place.canvas.width || frame.size.width > place.canvas.width - place.x ||
        place.y > place.canvas.height || frame.size.height > place.canvas.height - place.y)
        return damaged(0, "the first frame leaves its canvas");
    Image canvas(place.canvas, 4, Sample::u8);
    const std::size_t channels = frame.channels;
    const std::byte* in = frame.bytes.data();
    for (std::size_t y = 0; y < frame.size.height; ++y) {
        std::byte* out = canvas.bytes.data() + ((y + place.y) * canvas.size.width + place.x) * 4;
        for (std::size_t x = 0; x < frame.size.width; ++x, in += channels, out += 4) {
            std::memcpy(out, in, channels);
            if (channels == 3) out[3] = std::byte{255};
        }
    }
    return canvas;
}

base::Result<Image> animation_start(FileBytes file, const base::Limits& limits) {
    const auto place = first_frame(file);
    if (!place) return tl::unexpected(place.error());
    const auto features = features_of(place->stream);
    if (!features) return tl::unexpected(features.error());
    const auto header = header_of(*features, limits);
    if (!header) return tl::unexpected(header.error());
    auto frame = pixels_of(place->stream, *header);
    if (!frame) return frame;
    return on_canvas(std::move(*frame), *place);
}

}  // namespace

bool sniff(FileBytes file) {
    return file.size() >= 12 && starts_with(file, "RIFF") && starts_with(file.subspan(8), "WEBP");
}

base::Result<Header> read_header(FileBytes file, const base::Limits& limits) {
    const auto features = features_of(file);
    if (!features) return tl::unexpected(features.error());
    return header_of(*features, limits);
}

base::Result<Picture> read(FileBytes file, const base::Limits& limits, base::Warnings& warnings) {
    const auto features = features_of(file);
    if (!features) return tl::unexpected(features.error());
    const auto header = header_of(*features, limits);
    if (!header) return tl::unexpected(header.error());
    const FileBytes profile = icc_profile(file);
    if (!profile.empty() && !names_srgb(text_of(profile)))
        warnings.push_back(foreign_color_space("an ICC profile"));
    const bool is_animated = features->has_animation != 0;
    if (is_animated)
        warnings.push_back({.file = {},
                            .where = "ANIM",
                            .what = "an animated WebP; its first frame is used",
                            .found = {},
                            .remedy = {}});
    auto image = is_animated ? animation_start(file, limits) : pixels_of(file, *header);
    if (!image) return tl::unexpected(image.error());
    return one_layer(tables::ImageFormat::webp, std::move(*image));
}

}  // namespace facet::image::webp
