// Writes JPEG through libjpeg-turbo: quality 95, chroma at full resolution, alpha laid over black.
// SPDX-License-Identifier: MIT
#include "image/bytes.h"
#include "image/checks.h"
#include "image/dispatch.h"
#include "image/libjpeg.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdlib>

namespace facet::image::jpeg {
namespace {

/// All that outlives libjpeg's longjmp. `errors` comes first: libjpeg hands back a pointer to it
/// alone.
struct Writer {
    jpeg_error_mgr errors{};
    std::jmp_buf on_error{};
    jpeg_compress_struct info{};
    bool is_created = false;
    unsigned char* bytes = nullptr;
    unsigned long byte_count = 0;
    std::array<char, JMSG_LENGTH_MAX> problem{};

    Writer() = default;
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() {
        if (is_created) jpeg_destroy_compress(&info);
        std::free(bytes);
    }
};

[[noreturn]] void stop(j_common_ptr info) {
    auto& writer = *reinterpret_cast<Writer*>(info->err);
    info->err->format_message(info, writer.problem.data());
    std::longjmp(writer.on_error, 1);
}
void on_output(j_common_ptr /*info*/) {}

bool compress(Writer& writer, const Image& image) {
    if (setjmp(writer.on_error) != 0) return false;
    writer.info.err = jpeg_std_error(&writer.errors);
    writer.errors.error_exit = stop;
    writer.errors.output_message = on_output;
    jpeg_create_compress(&writer.info);
    writer.is_created = true;
    jpeg_mem_dest(&writer.info, &writer.bytes, &writer.byte_count);
    writer.info.image_width = image.size.width;
    writer.info.image_height = image.size.height;
    writer.info.input_components = static_cast<int>(image.channels);
    writer.info.in_color_space = image.channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&writer.info);
    jpeg_set_quality(&writer.info, 95, TRUE);
    writer.info.comp_info[0].h_samp_factor = 1;  // 4:4:4
    writer.info.comp_info[0].v_samp_factor = 1;
    jpeg_start_compress(&writer.info, TRUE);
    const std::size_t row_bytes = std::size_t{image.size.width} * image.channels;
    const auto* pixels = reinterpret_cast<const JSAMPLE*>(image.bytes.data());
    while (writer.info.next_scanline < writer.info.image_height) {
        // libjpeg's writing side takes no const, and does not write.
        JSAMPROW row = const_cast<JSAMPROW>(pixels + writer.info.next_scanline * row_bytes);
        jpeg_write_scanlines(&writer.info, &row, 1);
    }
    jpeg_finish_compress(&writer.info);
    return true;
}

/// The colours over black, in the encoded values, as browsers composite.
Image without_alpha(const Image& image) {
    if (image.channels == 1 || image.channels == 3) return image;
    const std::size_t colors = image.channels - 1;
    Image out(image.size, static_cast<std::uint32_t>(colors), Sample::u8);
    const auto from = image.as<std::uint8_t>();
    const auto to = out.as<std::uint8_t>();
    for (std::size_t i = 0, o = 0; i < from.size(); i += colors + 1, o += colors)
        for (std::size_t c = 0; c < colors; ++c)
            to[o + c] = static_cast<std::uint8_t>((from[i + c] * from[i + colors] + 127) / 255);
    return out;
}

}  // namespace

base::Result<base::Bytes> write(std::span<const Layer> layers, const WriteOptions& /*options*/) {
    const auto image = with_integer_depth(layers.front().image, Sample::u8);
    if (!image) return tl::unexpected(image.error());
    if (image->size.width > JPEG_MAX_DIMENSION || image->size.height > JPEG_MAX_DIMENSION)
        return base::fail({.code = base::ErrorCode::limit_reached,
                           .what = "too large for JPEG, which ends at 65500 pixels a side",
                           .found = {},
                           .remedy = "write PNG"});
    const Image opaque = without_alpha(*image);
    Writer writer;
    if (!compress(writer, opaque))
        return base::fail({.code = base::ErrorCode::internal,
                           .what = "the JPEG cannot be written",
                           .found = writer.problem.data()});
    base::Bytes out;
    append(out, std::as_bytes(std::span(writer.bytes, writer.byte_count)));
    return out;
}

}  // namespace facet::image::jpeg
