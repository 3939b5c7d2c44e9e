// Arrays for NumPy.
// SPDX-License-Identifier: MIT
#include "image/npy.h"

#include <spdlog/fmt/fmt.h>

#include <bit>
#include <cmath>

namespace facet::image {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they are");

std::string header(const Image& image, NpyType type) {
    std::string text =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}{}), }}",
                    type == NpyType::u32 ? "<u4" : "<f4", image.size.height, image.size.width,
                    image.channels == 1 ? std::string() : fmt::format(", {}", image.channels));
    // Magic, version, length and text take a multiple of 64 bytes.
    constexpr std::size_t before = 10;
    constexpr std::size_t block = 64;
    text.append(block - 1 - (before + text.size()) % block, ' ');
    text += '\n';
    const auto length = static_cast<std::uint16_t>(text.size());
    std::string out("\x93NUMPY\x01\x00", 8);
    out += static_cast<char>(length & 0xFFU);
    out += static_cast<char>(length >> 8U);
    return out + text;
}

}  // namespace

base::Bytes encode_npy(const Image& image, NpyType type) {
    const std::string head = header(image, type);
    const auto bytes = std::as_bytes(std::span(head));
    base::Bytes out(bytes.begin(), bytes.end());
    if (type == NpyType::f32) {
        out.insert(out.end(), image.bytes.begin(), image.bytes.end());
        return out;
    }
    for (const float value : image.as<float>()) {
        const auto whole = static_cast<std::uint32_t>(std::lround(value));
        const auto part = std::as_bytes(std::span(&whole, 1));
        out.insert(out.end(), part.begin(), part.end());
    }
    return out;
}

}  // namespace facet::image
