// The quick way through a plain PNG: one inflate by libdeflate, then the filters undone row by row.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "image/bytes.h"
#include "image/libdeflate.h"
#include "image/png_chunks.h"

#include <bit>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace facet::image::png {
namespace {

using Byte = std::uint8_t;

/// Paeth's predictor (W3C 2003, 9.4), without branches so that the channels of a pixel go side by
/// side.
int paeth(int a, int b, int c) {
    const int to_a = std::abs(b - c);
    const int to_b = std::abs(a - c);
    const int to_c = std::abs(a + b - 2 * c);
    const int b_or_c = to_b <= to_c ? b : c;
    return to_a <= to_b && to_a <= to_c ? a : b_or_c;
}

/// One row; `above` is the row before it, already decoded (zeros for the first). N: bytes per
/// pixel.
template <std::size_t N>
void undo_paeth(const Byte* in, const Byte* above, Byte* out, std::size_t bytes) {
    int a[N] = {};
    int c[N] = {};
    for (std::size_t i = 0; i < bytes; i += N)
        for (std::size_t k = 0; k < N; ++k) {
            const int b = above[i + k];
            a[k] = (in[i + k] + paeth(a[k], b, c[k])) & 0xFF;
            c[k] = b;
            out[i + k] = static_cast<Byte>(a[k]);
        }
}

template <std::size_t N>
void undo_sub(const Byte* in, Byte* out, std::size_t bytes) {
    Byte a[N] = {};
    for (std::size_t i = 0; i < bytes; i += N)
        for (std::size_t k = 0; k < N; ++k) {
            a[k] = static_cast<Byte>(in[i + k] + a[k]);
            out[i + k] = a[k];
        }
}

template <std::size_t N>
void undo_average(const Byte* in, const Byte* above, Byte* out, std::size_t bytes) {
    Byte a[N] = {};
    for (std::size_t i = 0; i < bytes; i += N)
        for (std::size_t k = 0; k < N; ++k) {
            a[k] = static_cast<Byte>(in[i + k] + ((a[k] + above[i + k]) >> 1));
            out[i + k] = a[k];
        }
}

/// Rows of [filter byte][bytes]. False at an unknown filter.
template <std::size_t N>
bool undo_filters(const Byte* in, Byte* out, std::size_t row_bytes, std::size_t rows) {
    const std::vector<Byte> zeros(row_bytes);
    const Byte* above = zeros.data();
    for (std::size_t y = 0; y < rows; ++y, in += row_bytes, out += row_bytes) {
        const Byte filter = *in++;
        switch (filter) {
            case 0:
                std::memcpy(out, in, row_bytes);
                break;
            case 1:
                undo_sub<N>(in, out, row_bytes);
                break;
            case 2:
                for (std::size_t i = 0; i < row_bytes; ++i)
                    out[i] = static_cast<Byte>(in[i] + above[i]);
                break;
            case 3:
                undo_average<N>(in, above, out, row_bytes);
                break;
            case 4:
                undo_paeth<N>(in, above, out, row_bytes);
                break;
            default:
                return false;
        }
        above = out;
    }
    return true;
}

bool undo_filters(std::size_t pixel_bytes, const Byte* in, Image& image) {
    const std::size_t row_bytes = image.size.width * pixel_bytes;
    Byte* out = image.as<Byte>().data();
    const std::size_t rows = image.size.height;
    switch (pixel_bytes) {
        case 1:
            return undo_filters<1>(in, out, row_bytes, rows);
        case 2:
            return undo_filters<2>(in, out, row_bytes, rows);
        case 3:
            return undo_filters<3>(in, out, row_bytes, rows);
        case 4:
            return undo_filters<4>(in, out, row_bytes, rows);
        case 6:
            return undo_filters<6>(in, out, row_bytes, rows);
        case 8:
            return undo_filters<8>(in, out, row_bytes, rows);
        default:
            return false;
    }
}

/// One buffer for all IDAT bodies; the file itself where there is one only.
FileBytes joined(const std::vector<FileBytes>& pieces, base::Bytes& storage) {
    if (pieces.size() == 1) return pieces.front();
    std::size_t total = 0;
    for (const FileBytes& piece : pieces) total += piece.size();
    storage.reserve(total);
    for (const FileBytes& piece : pieces) append(storage, piece);
    return storage;
}

/// PNG's words are big-endian.
void to_native_words(Image& image) {
    if constexpr (std::endian::native == std::endian::little)
        for (std::uint16_t& word : image.as<std::uint16_t>())
            word = static_cast<std::uint16_t>(word << 8 | word >> 8);
}

}  // namespace

std::optional<Image> read_plain(const Chunks& chunks) {
    if (chunks.bit_depth < 8 || chunks.interlaced || chunks.has_transparency ||
        chunks.color_type == ColorType::palette)
        return std::nullopt;
    const std::size_t pixel_bytes = chunks.channels() * sample_bytes(chunks.sample());
    const std::size_t stored_bytes = (chunks.size.width * pixel_bytes + 1) * chunks.size.height;
    base::Bytes storage;
    const FileBytes packed = joined(chunks.pixels, storage);
    // Left uninitialised: the inflate fills all of it or fails. Its size is the header's, so a bomb
    // stops here.
    const auto stored = std::make_unique_for_overwrite<Byte[]>(stored_bytes);
    const Decompressor inflater(libdeflate_alloc_decompressor());
    if (inflater == nullptr ||
        libdeflate_zlib_decompress(inflater.get(), packed.data(), packed.size(), stored.get(),
                                   stored_bytes, nullptr) != LIBDEFLATE_SUCCESS)
        return std::nullopt;
    Image image(chunks.size, chunks.channels(), chunks.sample());
    if (!undo_filters(pixel_bytes, stored.get(), image)) return std::nullopt;
    if (image.sample == Sample::u16) to_native_words(image);
    return image;
}

}  // namespace facet::image::png
