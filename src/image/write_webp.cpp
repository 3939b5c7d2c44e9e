// Writes WebP through libwebp: lossless, the colour beneath alpha 0 kept.
// SPDX-License-Identifier: MIT
#include "image/bytes.h"
#include "image/checks.h"
#include "image/dispatch.h"
#include "image/mips.h"

#include <spdlog/fmt/fmt.h>
#include <webp/encode.h>

#include <string>

namespace facet::image::webp {
namespace {

/// libwebp's picture and its output, freed together.
struct Writer {
    WebPPicture picture{};
    WebPMemoryWriter memory{};
    Writer() { WebPMemoryWriterInit(&memory); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() {
        WebPPictureFree(&picture);
        WebPMemoryWriterClear(&memory);
    }
};

tl::unexpected<base::Error> failed(int code) {
    return base::fail({.code = base::ErrorCode::internal,
                       .what = "the WebP cannot be written",
                       .found = fmt::format("libwebp error {}", code)});
}

}  // namespace

base::Result<base::Bytes> write(std::span<const Layer> layers, const WriteOptions& options) {
    const Image& image = layers.front().image;
    if (image.sample == Sample::f32) return failed(0);
    if (image.size.width > WEBP_MAX_DIMENSION || image.size.height > WEBP_MAX_DIMENSION)
        return base::fail({.code = base::ErrorCode::limit_reached,
                           .what = "too large for WebP, which ends at 16383 pixels a side",
                           .found = {},
                           .remedy = "write PNG"});
    const Image rgba = to_rgba8(image);
    WebPConfig config;
    Writer writer;
    if (WebPConfigInit(&config) == 0 || WebPPictureInit(&writer.picture) == 0) return failed(0);
    if (WebPConfigLosslessPreset(&config, options.fast ? 0 : 4) == 0) return failed(0);
    config.exact = 1;
    writer.picture.use_argb = 1;
    writer.picture.width = static_cast<int>(rgba.size.width);
    writer.picture.height = static_cast<int>(rgba.size.height);
    writer.picture.writer = WebPMemoryWrite;
    writer.picture.custom_ptr = &writer.memory;
    const auto* pixels = rgba.as<std::uint8_t>().data();
    const bool has_alpha = image.channels == 2 || image.channels == 4;
    const auto import = has_alpha ? WebPPictureImportRGBA : WebPPictureImportRGBX;
    if (import(&writer.picture, pixels, static_cast<int>(rgba.size.width * 4)) == 0 ||
        WebPEncode(&config, &writer.picture) == 0)
        return failed(static_cast<int>(writer.picture.error_code));
    base::Bytes out;
    append(out, std::as_bytes(std::span(writer.memory.mem, writer.memory.size)));
    return out;
}

}  // namespace facet::image::webp
