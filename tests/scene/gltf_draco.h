// glTF documents whose primitive is compressed with Draco's own encoder.
// SPDX-License-Identifier: MIT
#pragma once

#include <draco/compression/decode.h>
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "gltf_fixture.h"

namespace facet::test {

constexpr std::uint32_t draco_side = 5;

inline std::array<float, 3> draco_point(std::uint32_t x, std::uint32_t y) {
    return {static_cast<float>(x), static_cast<float>(y), std::sin(static_cast<float>(x * y))};
}
/// The corners of the wavy sheet's triangles, three a triangle.
inline std::vector<std::array<float, 3>> draco_corners() {
    std::vector<std::array<float, 3>> out;
    for (std::uint32_t y = 0; y + 1 < draco_side; ++y)
        for (std::uint32_t x = 0; x + 1 < draco_side; ++x)
            out.insert(out.end(),
                       {draco_point(x, y), draco_point(x + 1, y), draco_point(x, y + 1),
                        draco_point(x + 1, y), draco_point(x + 1, y + 1), draco_point(x, y + 1)});
    return out;
}

/// The sheet with positions (id 0), coordinates with a seam (1) and bytes of colors (2).
inline std::unique_ptr<draco::Mesh> draco_sheet() {
    const auto corners = draco_corners();
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(static_cast<int>(corners.size() / 3));
    const int position =
        builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
    const int color = builder.AddAttribute(draco::GeometryAttribute::COLOR, 4, draco::DT_UINT8);
    for (std::uint32_t face = 0; face < corners.size() / 3; ++face) {
        const auto* const c = &corners[std::size_t{face} * 3];
        const draco::FaceIndex at(face);
        builder.SetAttributeValuesForFace(position, at, c[0].data(), c[1].data(), c[2].data());
        // The lower half of the sheet has another piece of the picture.
        std::array<std::array<float, 2>, 3> coordinates{};
        for (std::size_t k = 0; k < 3; ++k)
            coordinates[k] = {c[k][0] * 0.125F, c[k][1] * 0.125F + (face < 16 ? 0.0F : 0.25F)};
        builder.SetAttributeValuesForFace(uv, at, coordinates[0].data(), coordinates[1].data(),
                                          coordinates[2].data());
        const std::array<std::uint8_t, 4> red{255, 0, 0, 255};
        builder.SetAttributeValuesForFace(color, at, red.data(), red.data(), red.data());
    }
    return builder.Finalize();
}

inline std::string draco_bytes(const draco::Mesh& mesh, int method, int position_bits = 0) {
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    encoder.SetSpeedOptions(5, 5);
    if (position_bits > 0)
        encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, position_bits);
    draco::EncoderBuffer buffer;
    const draco::Status status = encoder.EncodeMeshToBuffer(mesh, &buffer);
    EXPECT_TRUE(status.ok()) << status.error_msg();
    return {buffer.data(), buffer.size()};
}

/// A document of the stream alone. Accessors: 0 positions, 1 coordinates, 2 colors, 3 indices.
inline Document draco_document(int method = draco::MESH_EDGEBREAKER_ENCODING,
                               int position_bits = 0) {
    const auto mesh = draco_sheet();
    const std::string stream = draco_bytes(*mesh, method, position_bits);
    draco::DecoderBuffer buffer;
    buffer.Init(stream.data(), stream.size());
    auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    EXPECT_TRUE(decoded.ok());
    const std::size_t points = decoded.ok() ? decoded.value()->num_points() : 0;
    Document d;
    const std::size_t view = d.view(stream);
    d.json["accessors"] = {
        {{"componentType", 5126},
         {"count", points},
         {"type", "VEC3"},
         {"min", {0, 0, -1}},
         {"max", {4, 4, 1}}},
        {{"componentType", 5126}, {"count", points}, {"type", "VEC2"}},
        {{"componentType", 5121}, {"count", points}, {"type", "VEC4"}, {"normalized", true}},
        {{"componentType", 5123}, {"count", draco_corners().size()}, {"type", "SCALAR"}}};
    d.json["meshes"] = {
        {{"primitives",
          {{{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}, {"COLOR_0", 2}}},
            {"indices", 3},
            {"extensions",
             {{"KHR_draco_mesh_compression",
               {{"bufferView", view},
                {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}, {"COLOR_0", 2}}}}}}}}}}}};
    d.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    d.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    d.json["nodes"] = {{{"mesh", 0}}};
    return d;
}
inline Json& draco_use(Document& d) {
    return d.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
}

}  // namespace facet::test
