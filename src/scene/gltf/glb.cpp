// The GLB container: a 12-byte header, then chunks of {length, type, bytes}.
// SPDX-License-Identifier: MIT
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

/// The length field; nothing where there is no use in going on.
std::optional<std::size_t> read_header(std::span<const std::byte> file, Problems& problems) {
    if (file.size() < header_bytes) {
        problems.error("GLB_UNEXPECTED_END_OF_HEADER", offset_text(file.size()),
                       "GLB header is cut off", fmt::format("{} bytes of 12", file.size()));
        return std::nullopt;
    }
    if (read_u32(file, 0) != magic) {
        problems.error("GLB_INVALID_MAGIC", "@0x0", "not a GLB",
                       fmt::format("starts with {:#x}", read_u32(file, 0)));
        return std::nullopt;
    }
    if (const std::uint32_t version = read_u32(file, 4); version != 2) {
        problems.error("GLB_INVALID_VERSION", "@0x4", "GLB container version is not 2",
                       std::to_string(version));
        return std::nullopt;
    }
    const std::size_t length = read_u32(file, 8);
    if (length <= header_bytes)
        problems.error("GLB_LENGTH_TOO_SMALL", "@0x8", "GLB length field is too small",
                       std::to_string(length));
    return length;
}

struct Chunk {
    std::size_t at = 0;  ///< of its header
    std::uint32_t type = 0;
    std::span<const std::byte> bytes;
};

/// The chunk at `at`; nothing where it does not fit. `length` is what the header says of the whole.
std::optional<Chunk> read_chunk(std::span<const std::byte> file, std::size_t at, std::size_t length,
                                Problems& problems) {
    const std::string where = offset_text(at);
    if (file.size() - at < chunk_header_bytes) {
        problems.error("GLB_UNEXPECTED_END_OF_CHUNK_HEADER", where, "GLB chunk header is cut off");
        return std::nullopt;
    }
    const std::size_t size = read_u32(file, at);
    if (size % 4 != 0)
        problems.error("GLB_CHUNK_LENGTH_UNALIGNED", where,
                       "GLB chunk length is not a multiple of 4", std::to_string(size));
    const std::size_t start = at + chunk_header_bytes;
    if (start > length || size > length - start)
        problems.error("GLB_CHUNK_TOO_BIG", where, "GLB chunk leaves the length of the whole",
                       fmt::format("{} bytes from {}, but there are {}", size, start, length));
    if (size > file.size() - start) {
        problems.error("GLB_UNEXPECTED_END_OF_CHUNK_DATA", where, "GLB chunk leaves the file",
                       fmt::format("{} bytes, but there are {}", size, file.size() - start));
        return std::nullopt;
    }
    return Chunk{.at = at, .type = read_u32(file, at + 4), .bytes = file.subspan(start, size)};
}

/// The chunks seen so far.
struct Seen {
    std::size_t count = 0;
    std::optional<std::string_view> json;
    std::optional<std::span<const std::byte>> bin;
};

void take_json(const Chunk& chunk, Seen& seen, Problems& problems) {
    if (chunk.bytes.empty())
        problems.error("GLB_EMPTY_CHUNK", offset_text(chunk.at), "the GLB's JSON chunk is empty");
    if (seen.json) {
        problems.error("GLB_DUPLICATE_CHUNK", offset_text(chunk.at),
                       "second JSON chunk in the GLB");
        return;
    }
    seen.json.emplace(reinterpret_cast<const char*>(chunk.bytes.data()), chunk.bytes.size());
}

void take_bin(const Chunk& chunk, Seen& seen, Problems& problems) {
    const std::string where = offset_text(chunk.at);
    if (seen.bin) {
        problems.error("GLB_DUPLICATE_CHUNK", where, "second BIN chunk in the GLB");
        return;
    }
    if (seen.count > 1)
        problems.error("GLB_UNEXPECTED_BIN_CHUNK", where, "the BIN chunk is not the GLB's second");
    if (chunk.bytes.empty())
        problems.note(Severity::information, "GLB_EMPTY_BIN_CHUNK", where,
                      "the GLB's BIN chunk is empty");
    seen.bin = chunk.bytes;
}

void take_chunk(const Chunk& chunk, Seen& seen, Problems& problems) {
    const std::string type = fmt::format("{:#010x}", chunk.type);
    if (seen.count == 0 && chunk.type != json_type)
        problems.error("GLB_UNEXPECTED_FIRST_CHUNK", offset_text(chunk.at),
                       "the first GLB chunk is not JSON", type);
    if (chunk.type == json_type)
        take_json(chunk, seen, problems);
    else if (chunk.type == bin_type)
        take_bin(chunk, seen, problems);
    else
        problems.note(Severity::warning, "GLB_UNKNOWN_CHUNK_TYPE", offset_text(chunk.at),
                      "unknown GLB chunk is skipped", type);
    ++seen.count;
}

}  // namespace

bool looks_like_glb(std::span<const std::byte> file) {
    return file.size() >= 4 && read_u32(file, 0) == magic;
}

std::optional<GlbChunks> split_glb(std::span<const std::byte> file, Problems& problems) {
    const std::optional<std::size_t> length = read_header(file, problems);
    if (!length) return std::nullopt;
    Seen seen;
    std::size_t at = header_bytes;
    while (at < file.size() && at < *length) {
        const std::optional<Chunk> chunk = read_chunk(file, at, *length, problems);
        if (!chunk) return std::nullopt;
        take_chunk(*chunk, seen, problems);
        at += chunk_header_bytes + chunk->bytes.size();
    }
    if (at != *length)
        problems.error("GLB_LENGTH_MISMATCH", "@0x8", "GLB length field is not that of the file",
                       fmt::format("{}, but there are {}", *length, at));
    else if (at < file.size())
        problems.note(Severity::warning, "GLB_EXTRA_DATA", offset_text(at),
                      "bytes after the GLB's end are ignored", std::to_string(file.size() - at));
    if (!seen.json) return std::nullopt;
    return GlbChunks{.json = *seen.json, .bin = seen.bin};
}

}  // namespace facet::scene::gltf
