// Numbers in files: big- and little-endian, read and written byte by byte.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace facet::image {

[[nodiscard]] inline std::uint8_t byte_at(std::span<const std::byte> bytes, std::size_t at) {
    return std::to_integer<std::uint8_t>(bytes[at]);
}
/// Preconditions of the four: `at` + 2 or 4 <= bytes.size().
[[nodiscard]] inline std::uint32_t big32(std::span<const std::byte> bytes, std::size_t at) {
    return std::uint32_t{byte_at(bytes, at)} << 24 | std::uint32_t{byte_at(bytes, at + 1)} << 16 |
           std::uint32_t{byte_at(bytes, at + 2)} << 8 | std::uint32_t{byte_at(bytes, at + 3)};
}
[[nodiscard]] inline std::uint32_t little32(std::span<const std::byte> bytes, std::size_t at) {
    return std::uint32_t{byte_at(bytes, at + 3)} << 24 |
           std::uint32_t{byte_at(bytes, at + 2)} << 16 |
           std::uint32_t{byte_at(bytes, at + 1)} << 8 | std::uint32_t{byte_at(bytes, at)};
}
[[nodiscard]] inline std::uint32_t little24(std::span<const std::byte> bytes, std::size_t at) {
    return std::uint32_t{byte_at(bytes, at + 2)} << 16 |
           std::uint32_t{byte_at(bytes, at + 1)} << 8 | std::uint32_t{byte_at(bytes, at)};
}

[[nodiscard]] inline std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
[[nodiscard]] inline bool starts_with(std::span<const std::byte> bytes, std::string_view magic) {
    return text_of(bytes).starts_with(magic);
}

inline void append(base::Bytes& out, std::span<const std::byte> bytes) {
    out.insert(out.end(), bytes.begin(), bytes.end());
}
inline void append(base::Bytes& out, std::string_view text) {
    append(out, std::as_bytes(std::span(text)));
}
inline void append_big32(base::Bytes& out, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(static_cast<std::byte>(number >> shift & 0xFFU));
}
inline void append_little32(base::Bytes& out, std::uint32_t number) {
    for (int shift = 0; shift < 32; shift += 8)
        out.push_back(static_cast<std::byte>(number >> shift & 0xFFU));
}

}  // namespace facet::image
