// Reads JPEG through libjpeg-turbo: baseline and progressive, gray, YCbCr, RGB, CMYK and YCCK.
// SPDX-License-Identifier: MIT

#include "image/bytes.h"
#include "image/checks.h"
#include "image/dispatch.h"
#include "image/libjpeg.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <memory>
#include <string>

namespace facet::image::jpeg {
namespace {

/// A progressive file may repeat a scan without end, each as dear as a whole picture.
constexpr int scan_limit = 500;

/// All that outlives libjpeg's longjmp. `errors` comes first: libjpeg hands back a pointer to it
/// alone.
struct Reader {
    jpeg_error_mgr errors{};
    std::jmp_buf on_error{};
    jpeg_decompress_struct info{};
    jpeg_progress_mgr progress{};
    bool is_created = false;
    int code = 0;  ///< libjpeg's number of what went wrong
    std::array<char, JMSG_LENGTH_MAX> problem{};

    Reader() = default;
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() {
        if (is_created) jpeg_destroy_decompress(&info);
    }
};

[[noreturn]] void stop(j_common_ptr info) {
    auto& reader = *reinterpret_cast<Reader*>(info->err);
    reader.code = info->err->msg_code;
    info->err->format_message(info, reader.problem.data());
    std::longjmp(reader.on_error, 1);
}

/// libjpeg goes on with gray where data are missing; a picture that is not whole is refused
/// instead.
void on_message(j_common_ptr info, int level) {
    if (level >= 0) return;
    switch (info->err->msg_code) {
        case JWRN_EXTRANEOUS_DATA:  // bytes between markers: every pixel is there all the same
        case JWRN_ADOBE_XFORM:
        case JWRN_JFIF_MAJOR:
            return;
        default:
            stop(info);
    }
}
void on_progress(j_common_ptr info) {
    if (!info->is_decompressor) return;
    const auto* decoder = reinterpret_cast<j_decompress_ptr>(info);
    if (decoder->input_scan_number > scan_limit) {
        info->err->msg_code = JERR_CONVERSION_NOTIMPL;
        stop(info);
    }
}
void on_output(j_common_ptr /*info*/) {}

bool open(Reader& reader, FileBytes file) {
    if (setjmp(reader.on_error) != 0) return false;
    reader.info.err = jpeg_std_error(&reader.errors);
    reader.errors.error_exit = stop;
    reader.errors.emit_message = on_message;
    reader.errors.output_message = on_output;
    jpeg_create_decompress(&reader.info);
    reader.is_created = true;
    reader.progress.progress_monitor = on_progress;
    reader.info.progress = &reader.progress;
    jpeg_mem_src(&reader.info, reinterpret_cast<const unsigned char*>(file.data()),
                 static_cast<unsigned long>(file.size()));
    jpeg_save_markers(&reader.info, JPEG_APP0 + 2, 0xFFFF);  // ICC profile
    jpeg_read_header(&reader.info, TRUE);
    return true;
}

/// `rows` per call: fewer calls into the library.
bool read_rows(Reader& reader, JSAMPLE* pixels, std::size_t row_bytes) {
    if (setjmp(reader.on_error) != 0) return false;
    jpeg_start_decompress(&reader.info);
    while (reader.info.output_scanline < reader.info.output_height) {
        std::array<JSAMPROW, 8> rows{};
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::size_t y = std::min<std::size_t>(reader.info.output_scanline + i,
                                                        reader.info.output_height - 1);
            rows[i] = pixels + y * row_bytes;
        }
        jpeg_read_scanlines(
            &reader.info, rows.data(),
            std::min<JDIMENSION>(static_cast<JDIMENSION>(rows.size()),
                                 reader.info.output_height - reader.info.output_scanline));
    }
    jpeg_finish_decompress(&reader.info);
    return true;
}

tl::unexpected<base::Error> failed(const Reader& reader, FileBytes file) {
    const std::size_t left = reader.is_created && reader.info.src != nullptr
                                 ? std::min(reader.info.src->bytes_in_buffer, file.size())
                                 : 0;
    const std::size_t offset = file.size() - left;
    switch (reader.code) {
        case JERR_BAD_PRECISION:
        case JERR_SOF_UNSUPPORTED:
        case JERR_ARITH_NOTIMPL:
        case JERR_CONVERSION_NOTIMPL:
        case JERR_CCIR601_NOTIMPL:
        case JERR_FRACT_SAMPLE_NOTIMPL:
            return unsupported("this kind of JPEG is not supported", reader.problem.data());
        case JERR_OUT_OF_MEMORY:
            throw std::bad_alloc();
        case JERR_IMAGE_TOO_BIG:
            return base::fail({.code = base::ErrorCode::limit_reached,
                               .where = "header",
                               .what = "the JPEG is too large",
                               .found = reader.problem.data(),
                               .remedy = "scale the picture down"});
        case JERR_EMPTY_IMAGE:
            return damaged(offset, "the picture has no pixels");
        default:
            return damaged(offset, "the JPEG cannot be decoded", reader.problem.data());
    }
}

bool is_cmyk(const Reader& reader) {
    return reader.info.jpeg_color_space == JCS_CMYK || reader.info.jpeg_color_space == JCS_YCCK;
}

base::Result<Header> header_of(const Reader& reader, const base::Limits& limits) {
    const std::uint32_t channels = reader.info.num_components == 1 ? 1 : 3;
    if (reader.info.num_components == 2 || reader.info.num_components > 4)
        return unsupported("a JPEG with an odd number of channels",
                           fmt::format("{}", reader.info.num_components));
    // Progressive files hold all coefficients, 2 bytes each, beside the pixels.
    const auto components = static_cast<std::uint64_t>(reader.info.num_components);
    const std::uint64_t bytes =
        components + (reader.info.progressive_mode ? 2 * components : 0) + 1;
    const StatedSize size{reader.info.image_width, reader.info.image_height};
    if (auto checked = check_size(size, bytes, limits); !checked)
        return tl::unexpected(checked.error());
    return Header{tables::ImageFormat::jpeg,
                  {reader.info.image_width, reader.info.image_height},
                  channels,
                  Sample::u8};
}

void warn_of_profile(const Reader& reader, base::Warnings& warnings) {
    for (const jpeg_marker_struct* marker = reader.info.marker_list; marker != nullptr;
         marker = marker->next) {
        const std::string_view text(reinterpret_cast<const char*>(marker->data),
                                    marker->data_length);
        if (!text.starts_with("ICC_PROFILE")) continue;
        if (!names_srgb(text)) warnings.push_back(foreign_color_space("an ICC profile"));
        return;  // a profile's description stands in its first piece
    }
}

/// Adobe's CMYK is stored inverted, so ink-free is 255: RGB is C*K, M*K, Y*K. Without a profile no
/// more is known.
Image rgb_from_cmyk(const Image& cmyk, bool is_inverted) {
    Image rgb(cmyk.size, 3, Sample::u8);
    const auto from = cmyk.as<std::uint8_t>();
    const auto to = rgb.as<std::uint8_t>();
    const unsigned flip = is_inverted ? 0U : 255U;
    for (std::size_t i = 0, o = 0; i < from.size(); i += 4, o += 3)
        for (std::size_t c = 0; c < 3; ++c)
            to[o + c] = static_cast<std::uint8_t>(
                ((from[i + c] ^ flip) * (from[i + 3] ^ flip) + 127U) / 255U);
    return rgb;
}

base::Result<Image> pixels_of(Reader& reader, FileBytes file, const Header& header,
                              base::Warnings& warnings) {
    const bool from_cmyk = is_cmyk(reader);
    reader.info.out_color_space = from_cmyk              ? JCS_CMYK
                                  : header.channels == 1 ? JCS_GRAYSCALE
                                                         : JCS_RGB;
    Image image(header.size, from_cmyk ? 4 : header.channels, Sample::u8);
    if (!read_rows(reader, image.as<JSAMPLE>().data(),
                   std::size_t{image.size.width} * image.channels))
        return failed(reader, file);
    if (!from_cmyk) return image;
    warnings.push_back({.file = {},
                        .where = "header",
                        .what = "a CMYK picture, converted to RGB without its profile",
                        .found = {},
                        .remedy = "convert it to sRGB"});
    return rgb_from_cmyk(image, reader.info.saw_Adobe_marker != 0);
}

}  // namespace

bool sniff(FileBytes file) { return starts_with(file, "\xFF\xD8\xFF"); }

base::Result<Header> read_header(FileBytes file, const base::Limits& limits) {
    Reader reader;
    if (!open(reader, file)) return failed(reader, file);
    return header_of(reader, limits);
}

base::Result<Picture> read(FileBytes file, const base::Limits& limits, base::Warnings& warnings) {
    Reader reader;
    if (!open(reader, file)) return failed(reader, file);
    const auto header = header_of(reader, limits);
    if (!header) return tl::unexpected(header.error());
    warn_of_profile(reader, warnings);
    auto image = pixels_of(reader, file, *header, warnings);
    if (!image) return tl::unexpected(image.error());
    return one_layer(tables::ImageFormat::jpeg, std::move(*image));
}

}  // namespace facet::image::jpeg
