// Height maps in pictures: places and shadows by geometry, and raster against reference.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "image/write.h"
#include "scene/gltf_fixture.h"
#include "support/rendered.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace facet::render {
namespace {

using support::TemporaryFolder;
using test::Document;

constexpr float bar_m = 0.2F;  ///< height of the bar
constexpr float texel_m = 1.0F / 32.0F;

/// A floor of 2 x 2 m around the origin, of two triangles; its height map has a bar along z, eight
/// texels wide, that ends at x = 0 but for the slope.
std::string floor_with_bar(const TemporaryFolder& folder) {
    image::Image map({64, 64}, 1, image::Sample::u8);
    for (std::size_t i = 0; i < map.sample_count(); ++i)
        if (i % 64 >= 24 && i % 64 < 32) map.as<std::uint8_t>()[i] = 255;
    const auto png = image::encode(map, {});
    EXPECT_TRUE(png && base::write_file_atomically(folder / "height.png", *png));
    Document d;
    const std::size_t position = d.positions({-1, 0, 1, 1, 0, 1, 1, 0, -1, -1, 0, -1});
    const std::size_t normal = d.floats("VEC3", 3, {0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0});
    const std::size_t uv = d.floats("VEC2", 2, {0, 1, 1, 1, 1, 0, 0, 0});
    const std::size_t index = d.accessor<std::uint16_t>("SCALAR", 5123, 6, {0, 1, 2, 0, 2, 3});
    d.json["meshes"] = {
        {{"primitives",
          {{{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}},
            {"indices", index},
            {"material", 0}}}}}};
    d.json["nodes"] = {{{"mesh", 0}}};
    d.json["images"] = {{{"uri", "height.png"}}};
    d.json["textures"] = {{{"source", 0}}};
    d.json["materials"] = {
        {{"name", "floor"},
         {"pbrMetallicRoughness", {{"metallicFactor", 0}}},
         {"extras", {{"facet", {{"height", {{"texture", {{"index", 0}}}, {"scale_m", bar_m}}}}}}}}};
    return folder.write("floor.gltf", d.text()).string();
}

/// Layers `position` and `diffuse_direct` seen from straight above, under a sun from -x, 30 degrees
/// high.
std::vector<image::Layer> seen_from_above(const std::string& scene, bool by_reference,
                                          const std::string& shadows = "traced") {
    Request request{.scene = scene};
    tables::Settings& s = request.settings;
    s.size = {200, 40};
    s.camera = "orbit:azimuth=0,elevation=90,distance=8,target=0 0 0";
    s.fov = 3.0F;
    s.env = "black";
    s.exposure = "1";
    s.light = {"directional:azimuth=-90,elevation=30,lux=3"};
    s.shadows = shadows;
    s.aov = {"position", "diffuse_direct"};
    if (by_reference) s.reference = "16";
    auto rendered = test::rendered(request);
    return rendered ? std::move(rendered->layers) : std::vector<image::Layer>{};
}

TEST(Relief, StandsWhereItsMapSaysAndThrowsAShadowAsLongAsTheSunIsLow) {
    const TemporaryFolder folder;
    const std::string scene = floor_with_bar(folder);
    const float shadow_m = bar_m / std::tan(math::pi / 6.0F);
    for (const bool by_reference : {false, true}) {
        SCOPED_TRACE(by_reference ? "reference" : "raster");
        const auto layers = seen_from_above(scene, by_reference);
        ASSERT_GE(layers.size(), 2U);
        const auto places = layers[layers.size() - 2].image.as<float>();
        const auto light = layers.back().image.as<float>();
        ASSERT_EQ(places.size(), light.size());
        int on_top = 0;
        int dark = 0;
        int lit = 0;
        for (std::size_t i = 0; i < places.size(); i += 3) {
            const float x = places[i];
            // Rising and falling takes four texels.
            if (x > -0.25F + 2.1F * texel_m && x < -2.1F * texel_m) {
                EXPECT_NEAR(places[i + 1], bar_m, 1e-3F) << x;
                ++on_top;
            } else if (x > 2.1F * texel_m || x < -0.25F - 2.1F * texel_m) {
                EXPECT_NEAR(places[i + 1], 0.0F, 1e-3F) << x;
            }
            // The shadow is that of the bar's upper edge, at -1 to -2 texels.
            if (x > 2.0F * texel_m && x < shadow_m - 2.0F * texel_m) {
                EXPECT_LT(light[i], 1e-4F) << x;
                ++dark;
            }
            if (x > shadow_m - texel_m && x < 0.9F) {
                EXPECT_GT(light[i], 0.3F) << x;
                ++lit;
            }
        }
        EXPECT_GT(on_top, 400);
        EXPECT_GT(dark, 500);
        EXPECT_GT(lit, 100);
    }
}

TEST(Relief, OfTheBundledSceneIsAsTheReferenceHasIt) {
    struct Case {
        const char* light;
        const char* env;
        double most;
    };
    for (const Case& by : {Case{"", "studio", 0.03},
                           Case{"directional:azimuth=-70,elevation=20,lux=6", "black", 0.03}}) {
        Request request = test::small_request("builtin:relief", by.env);
        request.settings.size = {160, 90};
        request.settings.reference = "64";
        request.settings.compare = true;
        if (*by.light != '\0') request.settings.light = {by.light};
        EXPECT_LT(test::rmse_to_reference(request), by.most) << by.env << by.light;
    }
}

}  // namespace
}  // namespace facet::render
