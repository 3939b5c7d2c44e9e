// glTF documents whose buffer views are compressed with meshoptimizer's own encoder.
// SPDX-License-Identifier: MIT
#pragma once

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "gltf_fixture.h"

namespace facet::test {

template <class T>
std::string encode_attributes(const std::vector<T>& values, std::size_t stride) {
    const std::size_t count = values.size() * sizeof(T) / stride;
    std::vector<unsigned char> out(meshopt_encodeVertexBufferBound(count, stride));
    out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), values.data(), count, stride));
    return {out.begin(), out.end()};
}
/// `is_list` as triangles, else as a sequence of any kind; version 1, as glTF wants both.
inline std::string encode_indices(const std::vector<std::uint32_t>& indices, bool is_list) {
    const std::size_t vertex_count = *std::max_element(indices.begin(), indices.end()) + 1;
    meshopt_encodeIndexVersion(1);
    std::vector<unsigned char> out(
        is_list ? meshopt_encodeIndexBufferBound(indices.size(), vertex_count)
                : meshopt_encodeIndexSequenceBound(indices.size(), vertex_count));
    out.resize(
        is_list
            ? meshopt_encodeIndexBuffer(out.data(), out.size(), indices.data(), indices.size())
            : meshopt_encodeIndexSequence(out.data(), out.size(), indices.data(), indices.size()));
    return {out.begin(), out.end()};
}

/// How a view is packed.
struct Packed {
    std::string encoded;
    const char* mode;
    std::size_t count;
    std::size_t stride;
    const char* filter = nullptr;
};

/// Puts `packed` in the place of view `index`: its plain bytes become rubbish, and it moves to the
/// second buffer, which has none.
inline void pack_view(Document& d, std::size_t index, const Packed& packed,
                      const std::string& extension) {
    Json& view = d.json["bufferViews"][index];
    const auto begin = d.bytes.begin() + view["byteOffset"].get<std::ptrdiff_t>();
    std::fill(begin, begin + view["byteLength"].get<std::ptrdiff_t>(), '\xEE');
    view["buffer"] = 1;
    view["byteOffset"] = d.placeholder_bytes;
    view["byteLength"] = packed.count * packed.stride;
    d.placeholder_bytes += (packed.count * packed.stride + 3) / 4 * 4;
    d.bytes.resize((d.bytes.size() + 3) / 4 * 4);
    Json stream{{"buffer", 0},
                {"byteOffset", d.bytes.size()},
                {"byteLength", packed.encoded.size()},
                {"byteStride", packed.stride},
                {"count", packed.count},
                {"mode", packed.mode}};
    if (packed.filter != nullptr) stream["filter"] = packed.filter;
    view["extensions"][extension] = stream;
    d.bytes += packed.encoded;
}
inline std::size_t view_of(const Document& d, std::size_t accessor) {
    return d.json["accessors"][accessor]["bufferView"];
}

/// A wavy sheet of 9 x 9 vertices and 128 triangles, with coordinates.
struct Sheet {
    std::vector<float> positions;
    std::vector<std::uint16_t> uv;
    std::vector<std::uint32_t> indices;
};
inline Sheet sheet() {
    constexpr std::uint32_t side = 9;
    Sheet out;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            out.positions.insert(out.positions.end(), {static_cast<float>(x), static_cast<float>(y),
                                                       std::sin(static_cast<float>(x + y))});
            out.uv.push_back(static_cast<std::uint16_t>(x * 8191));
            out.uv.push_back(static_cast<std::uint16_t>(y * 8191));
            if (x + 1 == side || y + 1 == side) continue;
            const std::uint32_t at = y * side + x;
            out.indices.insert(out.indices.end(),
                               {at, at + 1, at + side, at + 1, at + side + 1, at + side});
        }
    return out;
}

/// The sheet with all three of its views packed. Accessors: 0 positions, 1 coordinates, 2 indices.
inline Document packed_sheet(const std::string& extension) {
    const Sheet s = sheet();
    Document d;
    d.positions(s.positions);
    const std::size_t uv = d.accessor("VEC2", 5123, s.uv.size() / 2, s.uv);
    d.json["accessors"][uv]["normalized"] = true;
    const std::size_t index =
        d.accessor("SCALAR", 5123, s.indices.size(),
                   std::vector<std::uint16_t>(s.indices.begin(), s.indices.end()));
    pack_view(d, view_of(d, 0),
              {encode_attributes(s.positions, 12), "ATTRIBUTES", s.positions.size() / 3, 12},
              extension);
    pack_view(d, view_of(d, uv), {encode_attributes(s.uv, 4), "ATTRIBUTES", s.uv.size() / 2, 4},
              extension);
    pack_view(d, view_of(d, index),
              {encode_indices(s.indices, true), "TRIANGLES", s.indices.size(), 2}, extension);
    d.json["extensionsUsed"] = {extension};
    d.json["extensionsRequired"] = {extension};
    d.json["meshes"] = {
        {{"primitives",
          {{{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", uv}}}, {"indices", index}}}}}};
    d.json["nodes"] = {{{"mesh", 0}}};
    return d;
}
/// The compressed form of view `index`.
inline Json& stream_of(Document& d, std::size_t index) {
    return d.json["bufferViews"][index]["extensions"].begin().value();
}

}  // namespace facet::test
