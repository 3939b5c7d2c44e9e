// The tiles of geometry in the chart of glTF features (gltf_chart.h), and what draws a tile.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/write.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "gltf_fixture.h"
namespace facet::test {

constexpr std::size_t chart_columns = 6;
constexpr std::size_t chart_rows = 4;
constexpr std::size_t tile_px = 16;

enum class Shown { with, without };

/// The document under way: tiles of 1 m, seen from +z by an orthographic camera of its own.
struct Chart {
    Document d;
    std::size_t tile = 0;  ///< the one that is drawn
    std::size_t quad = 0;  ///< accessors of a square of 0.8 m
    std::size_t corners = 0;
    std::size_t red = 0;
    std::size_t green = 0;

    Chart() {
        d.json["scenes"][0]["nodes"] = Json::array();
        d.json["nodes"] = Json::array();
        d.json["meshes"] = Json::array();
        quad = d.positions(square(0.4F));
        corners = d.accessor<std::uint16_t>("SCALAR", 5123, 6, {0, 1, 2, 0, 2, 3});
        red = material({0.7, 0.03, 0.03, 1});
        green = material({0.03, 0.6, 0.03, 1});
    }
    /// Corners, counter-clockwise seen from +z.
    [[nodiscard]] static std::vector<float> square(float half) {
        return {-half, -half, 0, half, -half, 0, half, half, 0, -half, half, 0};
    }
    [[nodiscard]] std::size_t material(const std::vector<double>& color, const Json& more = {}) {
        Json out{{"pbrMetallicRoughness",
                  {{"baseColorFactor", color}, {"metallicFactor", 0}, {"roughnessFactor", 1}}}};
        if (more.is_object()) out.merge_patch(more);
        d.json["materials"].push_back(out);
        return d.json["materials"].size() - 1;
    }
    /// A primitive of the square, or of other positions.
    [[nodiscard]] Json primitive(std::size_t of_material) const {
        return {
            {"attributes", {{"POSITION", quad}}}, {"indices", corners}, {"material", of_material}};
    }
    /// A node in the tile, `z_m` before the chart.
    Json& place(const Json& primitive, double z_m) {
        d.json["meshes"].push_back({{"primitives", {primitive}}});
        const double x = static_cast<double>(tile % chart_columns) - 0.5 * (chart_columns - 1);
        const double y = 0.5 * (chart_rows - 1) - static_cast<double>(tile / chart_columns);
        const std::size_t mesh = d.json["meshes"].size() - 1;
        d.json["scenes"][0]["nodes"].push_back(d.json["nodes"].size());
        d.json["nodes"].push_back({{"mesh", mesh}, {"translation", {x, y, z_m}}});
        return d.json["nodes"].back();
    }
    /// A red square that something green has to hide.
    void red_behind() { place(primitive(red), 0.0); }
    void use(const char* extension, bool is_required = false) {
        for (const char* const list : {"extensionsUsed", "extensionsRequired"}) {
            Json& names = d.json[list];
            if (std::find(names.begin(), names.end(), extension) == names.end())
                names.push_back(extension);
            if (!is_required) return;
        }
    }
    /// Of one colour for its left half and another for its right; an index of a texture.
    [[nodiscard]] std::size_t texture(std::array<std::uint8_t, 3> left,
                                      std::array<std::uint8_t, 3> right,
                                      tables::ImageFormat format = tables::ImageFormat::png) {
        image::Image pixels({16, 8}, 3, image::Sample::u8);
        const auto texels = pixels.as<std::uint8_t>();
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = (i / 3 % 16 < 8 ? left : right)[i % 3];
        const auto file = image::encode(pixels, {.format = format, .metadata = {}});
        EXPECT_TRUE(file);
        const std::size_t view =
            d.view({reinterpret_cast<const char*>(file->data()), file->size()});
        const bool is_webp = format == tables::ImageFormat::webp;
        d.json["images"].push_back(
            {{"bufferView", view}, {"mimeType", is_webp ? "image/webp" : "image/png"}});
        d.json["textures"].push_back({{"source", d.json["images"].size() - 1}});
        return d.json["textures"].size() - 1;
    }
    /// Coordinates that are the same at each corner; an accessor.
    [[nodiscard]] std::size_t coordinates(float u, float v) {
        return d.floats("VEC2", 2, {u, v, u, v, u, v, u, v});
    }
    [[nodiscard]] Document finish() && {
        d.json["cameras"] = {{{"type", "orthographic"},
                              {"orthographic",
                               {{"xmag", 0.5 * chart_columns},
                                {"ymag", 0.5 * chart_rows},
                                {"znear", 0.1},
                                {"zfar", 20}}}}};
        d.json["scenes"][0]["nodes"].push_back(d.json["nodes"].size());
        d.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 5}}});
        return std::move(d);
    }
};

constexpr std::array<std::uint8_t, 3> texel_red{220, 40, 40};
constexpr std::array<std::uint8_t, 3> texel_green{40, 200, 40};

inline Json textured(std::size_t texture, const Json& more = Json::object()) {
    Json use{{"index", texture}};
    use.merge_patch(more);
    return {{"pbrMetallicRoughness", {{"baseColorTexture", use}}}};
}

/// Draws one tile.
struct Tile {
    const char* name;
    std::function<void(Chart&, Shown)> draw;
    double codes = 5.0;  ///< of 255 between raster and reference: 0.02, as other pictures have
};

inline void draw_mode(Chart& chart, Shown shown, int mode, std::vector<float> positions) {
    chart.red_behind();
    if (shown == Shown::without) return;
    Json primitive = chart.primitive(chart.green);
    primitive.erase("indices");
    primitive["mode"] = mode;
    primitive["attributes"]["POSITION"] = chart.d.positions(positions);
    chart.place(primitive, 0.1);
}

/// Points or lines that hide most of the red behind them.
struct Thin {
    int mode;
    float apart_m;  ///< rows of them
    bool has_normals = false;
};
inline void draw_thin(Chart& chart, Shown shown, const Thin& thin) {
    chart.red_behind();
    if (shown == Shown::without) return;
    const auto rows = static_cast<int>(std::lround(0.8F / thin.apart_m));
    const bool is_points = thin.mode == 0;
    std::vector<float> positions;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= (is_points ? rows : 1); ++column)
            positions.insert(
                positions.end(),
                {-0.4F + (is_points ? thin.apart_m : 0.8F) * static_cast<float>(column),
                 -0.4F + thin.apart_m * static_cast<float>(row), 0.0F});
    Json primitive = chart.primitive(chart.green);
    primitive.erase("indices");
    primitive["mode"] = thin.mode;
    primitive["attributes"]["POSITION"] = chart.d.positions(positions);
    std::vector<float> normals;
    for (std::size_t i = 0; i < positions.size(); i += 3) normals.insert(normals.end(), {0, 0, 1});
    if (thin.has_normals) primitive["attributes"]["NORMAL"] = chart.d.floats("VEC3", 3, normals);
    chart.place(primitive, 0.1);
}

inline std::vector<Tile> geometry_tiles() {
    const float h = 0.4F;
    return {
        {"strip",
         [=](Chart& c, Shown s) {
             draw_mode(c, s, 5, {-h, -h, 0, h, -h, 0, -h, h, 0, h, h, 0});
         }},
        {"fan", [=](Chart& c, Shown s) { draw_mode(c, s, 6, Chart::square(h)); }},
        {"points",
         [](Chart& c, Shown s) {
             draw_thin(c, s, {0, 0.02F});
         }},
        {"lines",
         [](Chart& c, Shown s) {
             draw_thin(c, s, {1, 0.02F});
         }},
        {"line strip",
         [](Chart& c, Shown s) {
             draw_thin(c, s, {3, 0.02F});
         }},
        // 2 % darker in the reference: the line's normal sends some paths into the line's own body.
        {"lit lines",
         [](Chart& c, Shown s) {
             draw_thin(c, s, {1, 0.02F, true});
         },
         8.0},
        {"sparse",
         [](Chart& c, Shown s) {
             c.red_behind();
             // All corners but one lie in the middle, until three are replaced.
             const std::size_t at = c.d.positions({-0.4F, -0.4F, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
             if (s == Shown::with) {
                 const std::vector<std::uint16_t> which{1, 2, 3};
                 const std::vector<float> moved{0.4F, -0.4F, 0, 0.4F, 0.4F, 0, -0.4F, 0.4F, 0};
                 const std::size_t indices =
                     c.d.view({reinterpret_cast<const char*>(which.data()), 6});
                 const std::size_t values =
                     c.d.view({reinterpret_cast<const char*>(moved.data()), 36});
                 c.d.json["accessors"][at]["sparse"] = {
                     {"count", 3},
                     {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                     {"values", {{"bufferView", values}}}};
                 c.d.json["accessors"][at]["max"] = {0.4, 0.4, 0};
             }
             Json primitive = c.primitive(c.green);
             primitive["attributes"]["POSITION"] = at;
             c.place(primitive, 0.1);
         }},
        {"vertex colours, normalised",
         [](Chart& c, Shown s) {
             Json primitive = c.primitive(c.material({1, 0.5, 1, 1}));
             const std::vector<std::uint8_t> bytes{8, 255, 8, 255, 8, 255, 8, 255,
                                                   8, 255, 8, 255, 8, 255, 8, 255};
             const std::size_t color = c.d.accessor("VEC4", 5121, 4, bytes);
             c.d.json["accessors"][color]["normalized"] = true;
             if (s == Shown::with) primitive["attributes"]["COLOR_0"] = color;
             c.place(primitive, 0.0);
         }},
        {"instancing",
         [](Chart& c, Shown s) {
             c.red_behind();
             const std::size_t moves = c.d.floats("VEC3", 3, {0, 0, 2, 0, 0, 2.1F});
             Json& node = c.place(c.primitive(c.green), -1.9);
             c.use("EXT_mesh_gpu_instancing");
             if (s == Shown::with)
                 node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
                     {"TRANSLATION", moves}};
         }},
        {"visibility",
         [](Chart& c, Shown s) {
             c.place(c.primitive(c.green), 0.0);
             c.use("KHR_node_visibility");
             Json& node = c.place(c.primitive(c.red), 0.1);
             node["extensions"]["KHR_node_visibility"]["visible"] = s == Shown::without;
         }},
        {"quantised",
         [](Chart& c, Shown s) {
             c.red_behind();
             const auto at = c.d.accessor<std::int16_t>(
                 "VEC3", 5122, 4,
                 {-4000, -4000, 0, 0, 4000, -4000, 0, 0, 4000, 4000, 0, 0, -4000, 4000, 0, 0});
             c.d.json["bufferViews"].back()["byteStride"] = 8;
             c.d.json["accessors"][at]["min"] = {-4000, -4000, 0};
             c.d.json["accessors"][at]["max"] = {4000, 4000, 0};
             c.use("KHR_mesh_quantization", true);
             if (s == Shown::without) return;
             Json primitive = c.primitive(c.green);
             primitive["attributes"]["POSITION"] = at;
             c.place(primitive, 0.1)["scale"] = {1e-4, 1e-4, 1e-4};
         }},
    };
}

}  // namespace facet::test
