// Walks the chunks of a PNG file (W3C 2003, clauses 5 and 11).
// SPDX-License-Identifier: MIT
#include "image/png_chunks.h"

#include "image/bytes.h"
#include "image/checks.h"
#include "image/libdeflate.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <string_view>

namespace facet::image::png {
namespace {

constexpr std::size_t signature_bytes = 8;
constexpr std::size_t text_limit = std::size_t{1} << 20;  ///< longer metadata is left out

struct Chunk {
    std::string_view type;
    FileBytes body;
    std::size_t offset = 0;  ///< of the chunk in the file
    bool is_intact = false;  ///< the checksum holds
};

base::Result<Chunk> chunk_at(FileBytes file, std::size_t offset) {
    const std::size_t left = file.size() - offset;
    if (left < 12) return damaged(offset, "the file is cut short", fmt::format("{} bytes", left));
    const std::uint32_t length = big32(file, offset);
    if (length > left - 12)
        return damaged(offset, "a chunk is longer than the file", fmt::format("{} bytes", length));
    Chunk chunk;
    chunk.type = text_of(file.subspan(offset + 4, 4));
    chunk.body = file.subspan(offset + 8, length);
    chunk.offset = offset;
    // Only what is used is worth the time.
    if (chunk.type == "IHDR" || chunk.type == "IDAT") {
        const FileBytes covered = file.subspan(offset + 4, std::size_t{length} + 4);
        chunk.is_intact =
            libdeflate_crc32(0, covered.data(), covered.size()) == big32(file, offset + 8 + length);
    }
    return chunk;
}

bool is_allowed(std::uint8_t color_type, std::uint8_t bit_depth) {
    const bool is_byte_or_word = bit_depth == 8 || bit_depth == 16;
    const bool is_below_byte = bit_depth == 1 || bit_depth == 2 || bit_depth == 4;
    switch (color_type) {
        case 0:
            return is_byte_or_word || is_below_byte;
        case 3:
            return is_below_byte || bit_depth == 8;
        case 2:
        case 4:
        case 6:
            return is_byte_or_word;
        default:
            return false;
    }
}

base::Status read_ihdr(const Chunk& chunk, const base::Limits& limits, Chunks& out) {
    if (chunk.type != "IHDR" || chunk.body.size() != 13)
        return damaged(chunk.offset, "the header chunk IHDR is missing or malformed");
    if (!chunk.is_intact) return damaged(chunk.offset, "the checksum of IHDR does not hold");
    const StatedSize size{big32(chunk.body, 0), big32(chunk.body, 4)};
    out.bit_depth = byte_at(chunk.body, 8);
    const std::uint8_t color_type = byte_at(chunk.body, 9);
    if (!is_allowed(color_type, out.bit_depth))
        return damaged(chunk.offset, "no such colour type and bit depth",
                       fmt::format("{}, {}", color_type, out.bit_depth));
    if (byte_at(chunk.body, 10) != 0 || byte_at(chunk.body, 11) != 0 || byte_at(chunk.body, 12) > 1)
        return damaged(chunk.offset, "unknown compression, filter or interlace method");
    // Twice the pixels: as stored (filtered) and as returned; 4 channels, as a tRNS may follow.
    const std::uint64_t bytes_per_pixel = out.bit_depth == 16 ? 16 : 8;
    if (auto checked = check_size(size, bytes_per_pixel, limits); !checked) return checked;
    out.color_type = static_cast<ColorType>(color_type);
    out.interlaced = byte_at(chunk.body, 12) == 1;
    out.size = {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)};
    return {};
}

/// tEXt is Latin-1, and ours and nearly everybody's is ASCII; iTXt is UTF-8. Compressed text is
/// left out.
void read_text(const Chunk& chunk, Chunks& out) {
    std::string_view body = text_of(chunk.body);
    const std::size_t end = body.find('\0');
    if (body.size() > text_limit || end == std::string_view::npos || end == 0 || end > 79) return;
    const std::string_view key = body.substr(0, end);
    body.remove_prefix(end + 1);
    if (chunk.type == "iTXt") {
        if (body.size() < 2 || body[0] != '\0') return;
        body.remove_prefix(2);
        for (int skipped = 0; skipped < 2; ++skipped) {  // language tag, translated keyword
            const std::size_t stop = body.find('\0');
            if (stop == std::string_view::npos) return;
            body.remove_prefix(stop + 1);
        }
    }
    out.text.emplace_back(key, body);
}

/// iCCP: a name, a 0, the method 0, and the profile, deflated. One that does not unpack to 1 MiB is
/// not sRGB's.
bool is_srgb_profile(FileBytes body) {
    const std::size_t end = text_of(body).find('\0');
    if (end == std::string_view::npos || body.size() - end < 2) return false;
    if (names_srgb(text_of(body.first(end)))) return true;
    const FileBytes packed = body.subspan(end + 2);
    std::string profile(std::size_t{1} << 20, '\0');
    const Decompressor inflater(libdeflate_alloc_decompressor());
    std::size_t length = 0;
    if (inflater == nullptr ||
        libdeflate_zlib_decompress(inflater.get(), packed.data(), packed.size(), profile.data(),
                                   profile.size(), &length) != LIBDEFLATE_SUCCESS)
        return false;
    return names_srgb(std::string_view(profile).substr(0, length));
}

void read_ancillary(const Chunk& chunk, Chunks& out) {
    const std::string_view type = chunk.type;
    if (type == "tRNS") out.has_transparency = true;
    if (type == "acTL") out.is_animated = true;
    if (type == "sRGB") out.is_srgb = true;
    if (type == "tEXt" || type == "iTXt") read_text(chunk, out);
    if (type == "iCCP" && !is_srgb_profile(chunk.body)) out.color_space = "an ICC profile";
    // cICP 1/13/0/1 is sRGB (ITU-T H.273).
    if (type == "cICP" && chunk.body.size() == 4 &&
        (byte_at(chunk.body, 0) != 1 || byte_at(chunk.body, 1) != 13))
        out.color_space = "cICP";
    if (type == "gAMA" && chunk.body.size() == 4 && out.color_space.empty()) {
        const std::uint32_t gamma = big32(chunk.body, 0);
        if (gamma < 44000 || gamma > 47000)  // 45455 is 1/2.2, what stands for sRGB
            out.color_space = fmt::format("gAMA {}", gamma);
    }
}

base::Result<Chunks> walk(FileBytes file, Scope scope, Chunks out) {
    std::size_t at = signature_bytes + 25;
    while (true) {
        const auto chunk = chunk_at(file, at);
        if (!chunk) return tl::unexpected(chunk.error());
        at += 12 + chunk->body.size();
        if (chunk->type == "IEND") break;
        if (chunk->type == "IDAT") {
            if (scope == Scope::header) return out;
            if (!chunk->is_intact)
                return damaged(chunk->offset, "the checksum of the pixels does not hold");
            out.pixels.push_back(chunk->body);
        } else {
            read_ancillary(*chunk, out);
        }
    }
    if (out.pixels.empty() || scope == Scope::header)
        return damaged(at, "the file ends without pixels");
    if (out.is_srgb) out.color_space.clear();
    return out;
}

}  // namespace

std::uint32_t Chunks::channels() const noexcept {
    const std::uint32_t alpha = has_transparency ? 1 : 0;
    switch (color_type) {
        case ColorType::gray:
            return 1 + alpha;
        case ColorType::gray_alpha:
            return 2;
        case ColorType::rgba:
            return 4;
        case ColorType::rgb:
        case ColorType::palette:
            return 3 + alpha;
    }
    return 0;
}

base::Result<Chunks> find_chunks(FileBytes file, Scope scope, const base::Limits& limits) {
    if (file.size() < signature_bytes) return damaged(file.size(), "the file is cut short");
    const auto first = chunk_at(file, signature_bytes);
    if (!first) return tl::unexpected(first.error());
    Chunks chunks;
    if (auto read = read_ihdr(*first, limits, chunks); !read) return tl::unexpected(read.error());
    return walk(file, scope, std::move(chunks));
}

}  // namespace facet::image::png
