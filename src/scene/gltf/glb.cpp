// The GLB container: a 12-byte header, then chunks of {length, type, bytes} (glTF 2.0,
// section 4.4). SPDX-License-Identifier: MIT
#include "scene/gltf/glb.h"

#include <spdlog/fmt/fmt.h>

#include <cstdint>
#include <string>

namespace facet::scene::gltf {
namespace {

constexpr std::uint32_t magic = 0x46546C67;      // "glTF"
constexpr std::uint32_t json_type = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t bin_type = 0x004E4942;   // "BIN\0"
constexpr std::size_t header_bytes = 12;
constexpr std::size_t chunk_header_bytes = 8;

std::uint32_t read_u32(std::span<const std::byte> file, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= std::to_integer<std::uint32_t>(file[at + i]) << (8 * i);
    return value;
}

std::string offset_text(std::size_t at) { return fmt::format("@{:#x}", at); }

/// The length that chunks may use: the header's, but never more than the file has.
std::optional<std::size_t> read_header(std::span<const std::byte> file, Problems& problems) {
    if (file.size() < header_bytes) {
        problems.error("GLB_UNEXPECTED_END_OF_HEADER", offset_text(file.size()),
                       "GLB header is cut off", fmt::format("{} bytes of 12", file.size()));
        return std::nullopt;
    }
    if (read_u32(file, 0) != magic) {
        problems.error("GLB_INVALID_MAGIC", "@0x0", "not a GLB",
                       fmt::format("{:#x}", read_u32(file, 0)));
        return std::nullopt;
    }
    const std::uint32_t version = read_u32(file, 4);
    if (version != 2) {
        problems.add({.code = "GLB_INVALID_VERSION",
                      .pointer = "@0x4",
                      .what = "GLB container version is not 2",
                      .found = std::to_string(version),
                      .error = base::ErrorCode::input_invalid});
        return std::nullopt;
    }
    const std::size_t length = read_u32(file, 8);
    if (length <= header_bytes) {
        problems.error("GLB_LENGTH_TOO_SMALL", "@0x8", "GLB length field is too small",
                       std::to_string(length));
        return std::nullopt;
    }
    if (length > file.size())
        problems.error("GLB_LENGTH_MISMATCH", "@0x8",
                       "GLB length field differs from the file's size",
                       fmt::format("{}, but there are {}", length, file.size()));
    if (length < file.size())
        problems.note(Severity::warning, "GLB_EXTRA_DATA", offset_text(length),
                      "bytes after the GLB's end are ignored",
                      std::to_string(file.size() - length));
    return std::min(length, file.size());
}

struct Chunk {
    std::size_t at = 0;  ///< of its header
    std::uint32_t type = 0;
    std::span<const std::byte> bytes;
};

/// Next chunk at `at`; nothing at the end or where it does not fit.
std::optional<Chunk> read_chunk(std::span<const std::byte> file, std::size_t at,
                                Problems& problems) {
    if (file.size() - at < chunk_header_bytes) {
        problems.error("GLB_UNEXPECTED_END_OF_CHUNK_HEADER", offset_text(at),
                       "GLB chunk header is cut off");
        return std::nullopt;
    }
    const std::size_t length = read_u32(file, at);
    Chunk chunk{.at = at, .type = read_u32(file, at + 4), .bytes = {}};
    if (length % 4 != 0)
        problems.error("GLB_CHUNK_LENGTH_UNALIGNED", offset_text(at),
                       "GLB chunk length is not a multiple of 4", std::to_string(length));
    const std::size_t left = file.size() - at - chunk_header_bytes;
    if (length > left) {
        problems.error("GLB_CHUNK_TOO_BIG", offset_text(at), "GLB chunk leaves the file",
                       fmt::format("{} bytes, but there are {}", length, left));
        return std::nullopt;
    }
    chunk.bytes = file.subspan(at + chunk_header_bytes, length);
    return chunk;
}

/// Takes one chunk into `chunks`; false where the walk must end.
bool take_chunk(const Chunk& chunk, bool is_first, std::optional<GlbChunks>& chunks,
                Problems& problems) {
    const std::string at = offset_text(chunk.at);
    if (is_first && chunk.type != json_type) {
        problems.error("GLB_UNEXPECTED_FIRST_CHUNK", at, "the first GLB chunk is not JSON",
                       fmt::format("{:#010x}", chunk.type));
        return false;
    }
    if (chunk.type == json_type) {
        if (!is_first) {
            problems.error("GLB_DUPLICATE_CHUNK", at, "second JSON chunk in the GLB");
        } else if (chunk.bytes.empty()) {
            problems.error("GLB_EMPTY_CHUNK", at, "the GLB's JSON chunk is empty");
        } else {
            chunks.emplace();
            chunks->json = {reinterpret_cast<const char*>(chunk.bytes.data()), chunk.bytes.size()};
        }
        return true;
    }
    if (chunk.type != bin_type) {
        problems.note(Severity::warning, "GLB_UNKNOWN_CHUNK_TYPE", at,
                      "unknown GLB chunk is skipped", fmt::format("{:#010x}", chunk.type));
        return true;
    }
    if (!chunks) return true;
    if (chunks->bin) {
        problems.error("GLB_DUPLICATE_CHUNK", at, "second BIN chunk in the GLB");
        return true;
    }
    if (chunk.bytes.empty())
        problems.note(Severity::information, "GLB_EMPTY_BIN_CHUNK", at,
                      "the GLB's BIN chunk is empty");
    chunks->bin = chunk.bytes;
    return true;
}

}  // namespace

bool looks_like_glb(std::span<const std::byte> file) {
    return file.size() >= 4 && read_u32(file, 0) == magic;
}

std::optional<GlbChunks> split_glb(std::span<const std::byte> file, Problems& problems) {
    const std::optional<std::size_t> length = read_header(file, problems);
    if (!length) return std::nullopt;
    const std::span<const std::byte> body = file.first(*length);
    std::optional<GlbChunks> chunks;
    std::size_t chunk_count = 0;
    for (std::size_t at = header_bytes; at < body.size();) {
        const std::optional<Chunk> chunk = read_chunk(body, at, problems);
        if (!chunk) break;
        if (chunk->type == bin_type && chunk_count != 1 && chunks && !chunks->bin)
            problems.error("GLB_UNEXPECTED_BIN_CHUNK", offset_text(at),
                           "the BIN chunk is not the GLB's second");
        if (!take_chunk(*chunk, chunk_count == 0, chunks, problems)) return std::nullopt;
        ++chunk_count;
        at += chunk_header_bytes + chunk->bytes.size();
    }
    if (!chunks && problems.error_count() == 0)
        problems.error("GLB_UNEXPECTED_FIRST_CHUNK", "@0xc", "the GLB has no JSON chunk");
    return chunks;
}

}  // namespace facet::scene::gltf
