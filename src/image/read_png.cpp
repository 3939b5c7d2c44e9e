// Reads PNG: plain files quickly, all others (palette, tRNS, 1 to 4 bits, interlaced) through
// libpng. SPDX-License-Identifier: MIT
#include "image/bytes.h"
#include "image/checks.h"
#include "image/dispatch.h"
#include "image/png_chunks.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <string>

namespace facet::image::png {
namespace {

/// All that outlives libpng's longjmp: nothing with a destructor may live between setjmp and the
/// jump.
struct Reader {
    png_structp png = nullptr;
    png_infop info = nullptr;
    FileBytes file;
    std::size_t at = 0;
    std::string problem;
    std::vector<png_bytep> rows;

    Reader() = default;
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    static_cast<Reader*>(png_get_error_ptr(png))->problem = message;
    png_longjmp(png, 1);
}
void on_warning(png_structp /*png*/, png_const_charp /*message*/) {
}  // libpng repairs what it warns of

void on_read(png_structp png, png_bytep to, std::size_t count) {
    auto& reader = *static_cast<Reader*>(png_get_io_ptr(png));
    if (count > reader.file.size() - reader.at) png_error(png, "the file is cut short");
    std::memcpy(to, reader.file.data() + reader.at, count);
    reader.at += count;
}

/// Header, and every transform that makes the pixels what Chunks says they are. False on error.
bool start(Reader& reader, const base::Limits& limits) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_set_read_fn(reader.png, &reader, on_read);
    png_set_user_limits(reader.png, limits.image_side_px, limits.image_side_px);
    png_set_chunk_malloc_max(reader.png, 8'000'000);
    png_read_info(reader.png, reader.info);
    png_set_expand(reader.png);  // palette to RGB, below 8 bits to 8, tRNS to alpha
    if constexpr (std::endian::native == std::endian::little) png_set_swap(reader.png);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return true;
}

bool read_rows(Reader& reader) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_read_image(reader.png, reader.rows.data());
    png_read_end(reader.png, nullptr);
    return true;
}

tl::unexpected<base::Error> failed(const Reader& reader) {
    return damaged(reader.at, "the PNG cannot be decoded", reader.problem);
}

base::Result<Image> read_with_libpng(FileBytes file, const Chunks& chunks,
                                     const base::Limits& limits) {
    Reader reader;
    reader.file = file;
    reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, on_error, on_warning);
    if (reader.png != nullptr) reader.info = png_create_info_struct(reader.png);
    if (reader.info == nullptr)
        return base::fail(
            {.code = base::ErrorCode::limit_reached, .what = "no memory for the PNG reader"});
    if (!start(reader, limits)) return failed(reader);
    // Asked of libpng, which may have dropped a tRNS whose checksum does not hold.
    Image image({png_get_image_width(reader.png, reader.info),
                 png_get_image_height(reader.png, reader.info)},
                png_get_channels(reader.png, reader.info),
                png_get_bit_depth(reader.png, reader.info) == 16 ? Sample::u16 : Sample::u8);
    const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
    if (image.size != chunks.size || row_bytes * image.size.height != image.bytes.size())
        return damaged(0, "the PNG's header contradicts its pixels");
    auto* const first = reinterpret_cast<png_bytep>(image.bytes.data());
    reader.rows.resize(image.size.height);
    for (std::size_t y = 0; y < reader.rows.size(); ++y) reader.rows[y] = first + y * row_bytes;
    if (!read_rows(reader)) return failed(reader);
    return image;
}

}  // namespace

bool sniff(FileBytes file) {
    using namespace std::string_view_literals;
    return starts_with(file, "\x89PNG\r\n\x1A\n"sv);
}

base::Result<Header> read_header(FileBytes file, const base::Limits& limits) {
    const auto chunks = find_chunks(file, Scope::header, limits);
    if (!chunks) return tl::unexpected(chunks.error());
    return Header{tables::ImageFormat::png, chunks->size, chunks->channels(), chunks->sample()};
}

base::Result<Picture> read(FileBytes file, const base::Limits& limits, base::Warnings& warnings) {
    auto chunks = find_chunks(file, Scope::whole, limits);
    if (!chunks) return tl::unexpected(chunks.error());
    if (!chunks->color_space.empty()) warnings.push_back(foreign_color_space(chunks->color_space));
    if (chunks->is_animated)
        warnings.push_back({.file = {},
                            .where = "acTL",
                            .what = "an animated PNG; its still picture is used",
                            .found = {},
                            .remedy = {}});
    auto plain = read_plain(*chunks);
    Image image;
    if (plain) {
        image = std::move(*plain);
    } else {
        auto decoded = read_with_libpng(file, *chunks, limits);
        if (!decoded) return tl::unexpected(decoded.error());
        image = std::move(*decoded);
    }
    Picture picture = one_layer(tables::ImageFormat::png, std::move(image));
    picture.metadata = std::move(chunks->text);
    return picture;
}

}  // namespace facet::image::png
