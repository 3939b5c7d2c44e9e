// A chart of glTF features: a tile each, green where the feature works and red where it is ignored.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "gltf_chart_deformed.h"
#include "gltf_chart_geometry.h"
#ifdef FACET_HAS_MESHOPT
#include "gltf_meshopt.h"
#endif
#ifdef FACET_HAS_DRACO
#include "gltf_draco.h"
#endif

namespace facet::test {

inline std::vector<Tile> material_tiles() {
    return {
        {"two sets of coordinates",
         [](Chart& c, Shown s) {
             const Json set{{"texCoord", s == Shown::with ? 1 : 0}};
             Json primitive = c.primitive(
                 c.material({1, 1, 1, 1}, textured(c.texture(texel_red, texel_green), set)));
             primitive["attributes"]["TEXCOORD_0"] = c.coordinates(0.25F, 0.5F);
             primitive["attributes"]["TEXCOORD_1"] = c.coordinates(0.75F, 0.5F);
             c.place(primitive, 0.0);
         }},
        {"texture transform",
         [](Chart& c, Shown s) {
             // Turned by a quarter, (0.1, 0.5) lies at (0.5, -0.1): with the offset in the right
             // half.
             const Json transform{{"offset", {0.3, 0.6}}, {"rotation", 1.5707963}};
             Json use{{"extensions", {{"KHR_texture_transform", transform}}}};
             if (s == Shown::without) use = Json::object();
             c.use("KHR_texture_transform");
             Json primitive = c.primitive(
                 c.material({1, 1, 1, 1}, textured(c.texture(texel_red, texel_green), use)));
             primitive["attributes"]["TEXCOORD_0"] = c.coordinates(0.1F, 0.5F);
             c.place(primitive, 0.0);
         }},
        {"WebP",
         [](Chart& c, Shown s) {
             const std::size_t webp =
                 c.texture(texel_green, texel_green, tables::ImageFormat::webp);
             const std::size_t png = c.texture(texel_red, texel_red);
             c.use("EXT_texture_webp");
             Json& textures = c.d.json["textures"];
             if (s == Shown::with)
                 textures[png]["extensions"]["EXT_texture_webp"] = {
                     {"source", textures[webp]["source"]}};
             Json primitive = c.primitive(c.material({1, 1, 1, 1}, textured(png)));
             primitive["attributes"]["TEXCOORD_0"] = c.coordinates(0.5F, 0.5F);
             c.place(primitive, 0.0);
             textures[webp]["extensions"]["EXT_texture_webp"] = {
                 {"source", textures[webp]["source"]}};
             textures[webp].erase("source");
         }},
        {"alpha mask",
         [](Chart& c, Shown s) {
             c.place(c.primitive(c.green), 0.0);
             const Json mode{{"alphaMode", s == Shown::with ? "MASK" : "OPAQUE"}};
             c.place(c.primitive(c.material({0.7, 0.03, 0.03, 0.4}, mode)), 0.1);
         }},
        {"alpha blending",
         [](Chart& c, Shown s) {
             c.place(c.primitive(c.green), 0.0);
             const Json mode{{"alphaMode", s == Shown::with ? "BLEND" : "OPAQUE"}};
             c.place(c.primitive(c.material({0.7, 0.03, 0.03, 0.2}, mode)), 0.1);
         }},
        {"double-sided",
         [](Chart& c, Shown s) {
             c.red_behind();
             Json primitive =
                 c.primitive(c.material({0.03, 0.6, 0.03, 1}, {{"doubleSided", s == Shown::with}}));
             primitive["indices"] =
                 c.d.accessor<std::uint16_t>("SCALAR", 5123, 6, {0, 2, 1, 0, 3, 2});
             c.place(primitive, 0.1);
         }},
        {"unlit",
         [](Chart& c, Shown s) {
             c.use("KHR_materials_unlit");
             Json unlit{{"extensions", {{"KHR_materials_unlit", Json::object()}}}};
             if (s == Shown::without) unlit = Json::object();
             c.place(c.primitive(c.material({0.01, 0.15, 0.01, 1}, unlit)), 0.0);
         }},
        {"variants",
         [](Chart& c, Shown s) {
             c.use("KHR_materials_variants");
             c.d.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "green"}}};
             Json primitive = c.primitive(c.red);
             if (s == Shown::with)
                 primitive["extensions"]["KHR_materials_variants"]["mappings"] = {
                     {{"variants", {0}}, {"material", c.green}}};
             c.place(primitive, 0.0);
         }},
    };
}

inline std::vector<Tile> codec_tiles() {
    std::vector<Tile> tiles;
#ifdef FACET_HAS_MESHOPT
    for (const char* const name : {"KHR_meshopt_compression", "EXT_meshopt_compression"})
        tiles.push_back({name, [name](Chart& c, Shown s) {
                             c.red_behind();
                             c.use(name, true);
                             const std::vector<float> square = Chart::square(0.4F);
                             const std::size_t at = c.d.positions(square);
                             pack_view(c.d, view_of(c.d, at),
                                       {encode_attributes(square, 12), "ATTRIBUTES", 4, 12}, name);
                             if (s == Shown::without) return;
                             Json primitive = c.primitive(c.green);
                             primitive["attributes"]["POSITION"] = at;
                             c.place(primitive, 0.1);
                         }});
#endif
#ifdef FACET_HAS_DRACO
    tiles.push_back(
        {"KHR_draco_mesh_compression", [](Chart& c, Shown s) {
             c.red_behind();
             c.use("KHR_draco_mesh_compression", true);
             draco::TriangleSoupMeshBuilder builder;
             builder.Start(2);
             const int id =
                 builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
             const std::vector<float> p = Chart::square(0.4F);
             builder.SetAttributeValuesForFace(id, draco::FaceIndex(0), &p[0], &p[3], &p[6]);
             builder.SetAttributeValuesForFace(id, draco::FaceIndex(1), &p[0], &p[6], &p[9]);
             const std::size_t view =
                 c.d.view(draco_bytes(*builder.Finalize(), draco::MESH_EDGEBREAKER_ENCODING));
             if (s == Shown::without) return;
             Json& accessors = c.d.json["accessors"];
             accessors.push_back({{"componentType", 5126},
                                  {"count", 4},
                                  {"type", "VEC3"},
                                  {"min", {-0.4, -0.4, 0}},
                                  {"max", {0.4, 0.4, 0}}});
             accessors.push_back({{"componentType", 5123}, {"count", 6}, {"type", "SCALAR"}});
             Json primitive = c.primitive(c.green);
             primitive["attributes"]["POSITION"] = accessors.size() - 2;
             primitive["indices"] = accessors.size() - 1;
             primitive["extensions"]["KHR_draco_mesh_compression"] = {
                 {"bufferView", view}, {"attributes", {{"POSITION", 0}}}};
             c.place(primitive, 0.1);
         }});
#endif
    return tiles;
}

inline std::vector<Tile> chart_tiles() {
    std::vector<Tile> all = geometry_tiles();
    for (auto* const part : {deformed_tiles, material_tiles, codec_tiles})
        for (Tile& tile : part()) all.push_back(std::move(tile));
    return all;
}

inline Document feature_chart(Shown shown) {
    Chart chart;
    for (const Tile& tile : chart_tiles()) {
        tile.draw(chart, shown);
        ++chart.tile;
    }
    return std::move(chart).finish();
}

/// Mean code of a channel over the middle of a tile.
inline double tile_mean(const image::Image& picture, std::size_t tile, std::size_t channel) {
    const std::size_t left = tile % chart_columns * tile_px + tile_px / 4;
    const std::size_t top = tile / chart_columns * tile_px + tile_px / 4;
    double sum = 0.0;
    const auto codes = picture.as<std::uint8_t>();
    for (std::size_t y = top; y < top + tile_px / 2; ++y)
        for (std::size_t x = left; x < left + tile_px / 2; ++x)
            sum += codes[(y * picture.size.width + x) * picture.channels + channel];
    return sum / static_cast<double>(tile_px / 2 * tile_px / 2);
}

}  // namespace facet::test
