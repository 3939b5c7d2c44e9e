// Writes PNG: rows filtered, one IDAT packed by libdeflate, an sRGB or cICP chunk, metadata as text
// chunks. SPDX-License-Identifier: MIT
#include "image/bytes.h"
#include "image/checks.h"
#include "image/dispatch.h"
#include "image/libdeflate.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

namespace facet::image::png {
namespace {

using Byte = std::uint8_t;

void append_chunk(base::Bytes& out, std::string_view type, FileBytes body) {
    append_big32(out, static_cast<std::uint32_t>(body.size()));
    const std::size_t start = out.size();
    append(out, type);
    append(out, body);
    append_big32(out, libdeflate_crc32(0, out.data() + start, out.size() - start));
}

base::Bytes ihdr(const Image& image) {
    base::Bytes body;
    append_big32(body, image.size.width);
    append_big32(body, image.size.height);
    constexpr std::array<Byte, 4> color_types{0, 4, 2, 6};
    const Byte depth = image.sample == Sample::u16 ? 16 : 8;
    for (const Byte byte : {depth, color_types[image.channels - 1], Byte{0}, Byte{0}, Byte{0}})
        body.push_back(static_cast<std::byte>(byte));
    return body;
}

/// tEXt where the text is ASCII, else iTXt (UTF-8). Keys are cut to the 79 bytes that the format
/// has.
void append_text(base::Bytes& out, const std::pair<std::string, std::string>& entry) {
    using namespace std::string_view_literals;
    const std::string_view key = std::string_view(entry.first).substr(0, 79);
    if (key.empty() || entry.second.size() > 0x7FFFFF00U) return;
    const bool is_ascii = std::ranges::all_of(
        entry.second, [](char c) { return static_cast<unsigned char>(c) < 128 && c != '\0'; });
    base::Bytes body;
    append(body, key);
    append(body, is_ascii ? "\0"sv : "\0\0\0\0\0"sv);
    append(body, entry.second);
    append_chunk(out, is_ascii ? "tEXt" : "iTXt", body);
}

/// Bytes of `row` as the file has them: words big-endian.
void stored_row(const Image& image, std::size_t y, std::span<Byte> row) {
    const auto* from = reinterpret_cast<const Byte*>(image.bytes.data()) + y * row.size();
    std::memcpy(row.data(), from, row.size());
    if (image.sample == Sample::u16 && std::endian::native == std::endian::little)
        for (std::size_t i = 0; i < row.size(); i += 2) std::swap(row[i], row[i + 1]);
}

/// Which colours the values are. cICP (W3C 2025, "Portable Network Graphics (Third
/// Edition)", 11.3.2.6) is what new readers know; cHRM and gAMA tell older ones of Display P3,
/// nothing tells them of PQ.
void append_colors(base::Bytes& out, tables::Gamut gamut) {
    if (gamut == tables::Gamut::srgb) {
        append_chunk(out, "sRGB", std::array<std::byte, 1>{});  // 0: perceptual intent
        return;
    }
    const tables::GamutRow& row = tables::row(gamut);
    base::Bytes body;
    for (const Byte byte : {row.primaries, row.transfer, Byte{0}, Byte{1}})  // RGB, full range
        body.push_back(static_cast<std::byte>(byte));
    append_chunk(out, "cICP", body);
    if (gamut != tables::Gamut::p3) return;
    body.clear();
    for (const std::uint32_t value :  // white, red, green, blue: x and y times 100,000
         {31270U, 32900U, 68000U, 32000U, 26500U, 69000U, 15000U, 6000U})
        append_big32(body, value);
    append_chunk(out, "cHRM", body);
    body.clear();
    append_big32(body, 45455);  // of sRGB's curve: 1 / 2.2 times 100,000
    append_chunk(out, "gAMA", body);
}

Byte paeth(int a, int b, int c) {
    const int to_a = std::abs(b - c);
    const int to_b = std::abs(a - c);
    const int to_c = std::abs(a + b - 2 * c);
    return static_cast<Byte>(to_a <= to_b && to_a <= to_c ? a : to_b <= to_c ? b : c);
}

struct Row {
    std::span<const Byte> now;
    std::span<const Byte> above;
    std::size_t pixel_bytes = 0;
};

/// One filter of PNG (W3C 2003, 9.2) over a row.
void apply_filter(int filter, const Row& row, Byte* out) {
    const std::size_t n = row.pixel_bytes;
    const Byte* x = row.now.data();
    const Byte* b = row.above.data();
    const std::size_t bytes = row.now.size();
    const auto each = [&](const auto& predicted) {
        for (std::size_t i = 0; i < n; ++i)
            out[i] = static_cast<Byte>(x[i] - predicted(0, b[i], 0));
        for (std::size_t i = n; i < bytes; ++i)
            out[i] = static_cast<Byte>(x[i] - predicted(x[i - n], b[i], b[i - n]));
    };
    switch (filter) {
        case 1:
            each([](int a, int, int) { return a; });
            break;
        case 2:
            each([](int, int up, int) { return up; });
            break;
        case 3:
            each([](int a, int up, int) { return (a + up) >> 1; });
            break;
        case 4:
            each([](int a, int up, int c) { return paeth(a, up, c); });
            break;
        default:
            std::memcpy(out, x, bytes);
            break;
    }
}

/// The heuristic of W3C 2003, 12.8: least sum of absolute differences, bytes read as signed.
std::uint64_t cost(const Byte* bytes, std::size_t count) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const int value = static_cast<std::int8_t>(bytes[i]);
        sum += static_cast<std::uint32_t>(value < 0 ? -value : value);
    }
    return sum;
}

/// All rows, each behind its filter's number. Quick: Up throughout, which a rendered picture likes
/// as well.
std::vector<Byte> filtered(const Image& image, bool fast) {
    const std::size_t pixel_bytes = image.channels * sample_bytes(image.sample);
    const std::size_t row_bytes = image.size.width * pixel_bytes;
    std::vector<Byte> now(row_bytes);
    std::vector<Byte> above(row_bytes);
    std::vector<Byte> trial(row_bytes);
    std::vector<Byte> out((row_bytes + 1) * image.size.height);
    Byte* to = out.data();
    for (std::size_t y = 0; y < image.size.height; ++y, to += row_bytes + 1) {
        stored_row(image, y, now);
        const Row row{now, above, pixel_bytes};
        *to = 2;
        apply_filter(2, row, to + 1);
        if (!fast) {
            std::uint64_t least = cost(to + 1, row_bytes);
            for (const int filter : {0, 1, 3, 4}) {
                apply_filter(filter, row, trial.data());
                const std::uint64_t sum = cost(trial.data(), row_bytes);
                if (sum >= least) continue;
                least = sum;
                *to = static_cast<Byte>(filter);
                std::memcpy(to + 1, trial.data(), row_bytes);
            }
        }
        std::swap(now, above);
    }
    return out;
}

base::Bytes packed(const std::vector<Byte>& rows, bool fast) {
    const Compressor deflater(libdeflate_alloc_compressor(fast ? 1 : 4));
    if (deflater == nullptr) throw std::bad_alloc();
    base::Bytes out(libdeflate_zlib_compress_bound(deflater.get(), rows.size()));
    out.resize(
        libdeflate_zlib_compress(deflater.get(), rows.data(), rows.size(), out.data(), out.size()));
    return out;
}

}  // namespace

base::Result<base::Bytes> write(std::span<const Layer> layers, const WriteOptions& options) {
    using namespace std::string_view_literals;
    const auto image = with_integer_depth(layers.front().image,
                                          options.depth == Depth::u16 ? Sample::u16 : Sample::u8);
    if (!image) return tl::unexpected(image.error());
    base::Bytes idat = packed(filtered(*image, options.fast), options.fast);
    // Pieces below 2^31 bytes: the format's limit for one chunk.
    constexpr std::size_t piece_bytes = std::size_t{1} << 30;
    base::Bytes out;
    out.reserve(idat.size() + 1024);
    append(out, "\x89PNG\r\n\x1A\n"sv);
    append_chunk(out, "IHDR", ihdr(*image));
    append_colors(out, options.gamut);
    for (const auto& entry : options.metadata) append_text(out, entry);
    for (std::size_t at = 0; at < idat.size(); at += piece_bytes)
        append_chunk(out, "IDAT",
                     FileBytes(idat).subspan(at, std::min(piece_bytes, idat.size() - at)));
    append_chunk(out, "IEND", {});
    return out;
}

}  // namespace facet::image::png
