// Walks the RIFF chunks of a WebP file (RFC 9649, section 2).
// SPDX-License-Identifier: MIT
#include "image/webp_chunks.h"

#include "image/bytes.h"
#include "image/checks.h"

#include <optional>
#include <string_view>

namespace facet::image::webp {
namespace {

constexpr std::size_t riff_header_bytes = 12;  // "RIFF", size, "WEBP"
constexpr std::size_t frame_header_bytes = 16;

struct Chunk {
    std::string_view type;
    FileBytes body;
    std::size_t next = 0;
};

/// Nothing at the end of `bytes`, or where a chunk would leave it.
std::optional<Chunk> chunk_at(FileBytes bytes, std::size_t at) {
    if (at > bytes.size() || bytes.size() - at < 8) return std::nullopt;
    const std::size_t length = little32(bytes, at + 4);
    if (length > bytes.size() - at - 8) return std::nullopt;
    return Chunk{text_of(bytes.subspan(at, 4)), bytes.subspan(at + 8, length),
                 at + 8 + length + length % 2};
}

std::optional<Chunk> find(FileBytes bytes, std::size_t at, std::string_view type) {
    for (auto chunk = chunk_at(bytes, at); chunk; chunk = chunk_at(bytes, chunk->next))
        if (chunk->type == type) return chunk;
    return std::nullopt;
}

void append_chunk(base::Bytes& out, std::string_view type, FileBytes body) {
    append(out, type);
    append_little32(out, static_cast<std::uint32_t>(body.size()));
    append(out, body);
    if (body.size() % 2 != 0) out.push_back(std::byte{0});
}

void append_little24(base::Bytes& out, std::uint32_t number) {
    for (int shift = 0; shift < 24; shift += 8)
        out.push_back(static_cast<std::byte>(number >> shift & 0xFFU));
}

}  // namespace

FileBytes icc_profile(FileBytes file) {
    const auto chunk = find(file, riff_header_bytes, "ICCP");
    return chunk ? chunk->body : FileBytes{};
}

base::Result<FirstFrame> first_frame(FileBytes file) {
    const auto canvas = find(file, riff_header_bytes, "VP8X");
    const auto frame = find(file, riff_header_bytes, "ANMF");
    if (!canvas || canvas->body.size() < 10 || !frame || frame->body.size() < frame_header_bytes)
        return damaged(riff_header_bytes, "an animated WebP without a whole frame");
    FirstFrame out;
    out.canvas = {little24(canvas->body, 4) + 1, little24(canvas->body, 7) + 1};
    out.x = little24(frame->body, 0) * 2;
    out.y = little24(frame->body, 3) * 2;
    const std::uint32_t width_less_1 = little24(frame->body, 6);
    const std::uint32_t height_less_1 = little24(frame->body, 9);
    const auto alpha = find(frame->body, frame_header_bytes, "ALPH");
    auto pixels = find(frame->body, frame_header_bytes, "VP8 ");
    if (!pixels) pixels = find(frame->body, frame_header_bytes, "VP8L");
    if (!pixels) return damaged(riff_header_bytes, "the first frame has no pixels");
    base::Bytes extended;
    append_little32(extended, alpha ? 0x10 : 0);  // the alpha flag
    append_little24(extended, width_less_1);
    append_little24(extended, height_less_1);
    base::Bytes chunks;
    append(chunks, "WEBP");
    append_chunk(chunks, "VP8X", extended);
    if (alpha) append_chunk(chunks, "ALPH", alpha->body);
    append_chunk(chunks, pixels->type, pixels->body);
    append(out.stream, "RIFF");
    append_little32(out.stream, static_cast<std::uint32_t>(chunks.size()));
    append(out.stream, chunks);
    return out;
}

}  // namespace facet::image::webp
