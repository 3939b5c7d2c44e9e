// Features of glTF in pictures: each tile of the chart is green, raster and reference agree on it,
// and it is red (or at least another) where the feature is left out.
// SPDX-License-Identifier: MIT
#include "scene/gltf_chart.h"
#include "support/rendered.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>

namespace facet::render {
namespace {

using test::Document;
using test::Json;
using test::Shown;

Request chart_request(const support::TemporaryFolder& folder, Shown shown) {
    const char* const name = shown == Shown::with ? "with.gltf" : "without.gltf";
    Request request = test::small_request(
        folder.write(name, test::feature_chart(shown).text()).string(), "furnace");
    request.settings.size = {test::chart_columns * test::tile_px, test::chart_rows * test::tile_px};
    request.settings.light = {"directional:azimuth=30,elevation=40,lux=6"};
    request.settings.variant = "green";
    return request;
}

TEST(GltfFeatures, EveryTileIsGreenInRasterAndReferenceAlikeAndAnotherWithoutItsFeature) {
    const support::TemporaryFolder folder;
    Request request = chart_request(folder, Shown::with);
    const auto raster = test::rendered(request);
    const auto without = test::rendered(chart_request(folder, Shown::without));
    request.settings.reference = "32";
    const auto reference = test::rendered(request);
    ASSERT_TRUE(raster && reference && without);
    for (const base::Warning& warning : raster->warnings) ADD_FAILURE() << base::to_line(warning);
    const std::vector<test::Tile> tiles = test::chart_tiles();
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        SCOPED_TRACE(tiles[t].name);
        double change = 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double here = test::tile_mean(raster->display, t, c);
            EXPECT_NEAR(here, test::tile_mean(reference->display, t, c), tiles[t].codes)
                << "channel " << c;
            change = std::max(change, std::abs(here - test::tile_mean(without->display, t, c)));
        }
        EXPECT_GT(test::tile_mean(raster->display, t, 1),
                  1.3 * test::tile_mean(raster->display, t, 0));
        EXPECT_GT(change, 25.0) << "the feature cannot be seen";
    }
}

/// Over all colours, of 1.
double codes_rmse(const image::Image& a, const image::Image& b) {
    const auto p = a.as<std::uint8_t>();
    const auto q = b.as<std::uint8_t>();
    EXPECT_EQ(p.size(), q.size());
    double squares = 0.0;
    for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i) {
        const double error = static_cast<double>(p[i] - q[i]) / 255.0;
        squares += error * error;
    }
    return std::sqrt(squares / static_cast<double>(p.size()));
}

/// Two squares of a chart, with a camera that sees as far as an orbit of the same angle.
TEST(GltfCamera, OfTheFileShowsWhatTheSameOrbitShows) {
    const support::TemporaryFolder folder;
    const double yfov = 0.6;
    for (const bool is_turned : {false, true}) {
        test::Chart chart;
        chart.place(chart.primitive(chart.green), 0.0)["translation"] = {0.3, 0.2, 0};
        chart.place(chart.primitive(chart.red), 0.0)["translation"] = {-0.4, -0.3, -1};
        Json camera{{"type", "perspective"}, {"perspective", {{"yfov", yfov}, {"znear", 0.1}}}};
        Document d = std::move(chart).finish();
        d.json["cameras"][0] = camera;
        // Around y by 30 degrees, 4 m away; or straight from the front.
        const double turn = is_turned ? static_cast<double>(math::pi) / 6.0 : 0.0;
        Json& node = d.json["nodes"].back();
        node["translation"] = {4.0 * std::sin(turn), 0, 4.0 * std::cos(turn)};
        node["rotation"] = {0, std::sin(0.5 * turn), 0, std::cos(0.5 * turn)};
        Request of_file =
            test::small_request(folder.write("camera.gltf", d.text()).string(), "furnace");
        of_file.settings.background = "#0000ff";
        Request orbit = of_file;
        orbit.settings.camera =
            fmt::format("orbit:azimuth={},elevation=0,distance=4,target=0 0 0", is_turned ? 30 : 0);
        orbit.settings.fov = static_cast<float>(yfov * 180.0 / static_cast<double>(math::pi));
        const auto a = test::rendered(of_file);
        const auto b = test::rendered(orbit);
        of_file.settings.reference = "16";
        const auto c = test::rendered(of_file);
        ASSERT_TRUE(a && b && c);
        EXPECT_LT(codes_rmse(a->display, b->display), 0.002);
        EXPECT_LT(codes_rmse(a->display, c->display), 0.02);
        of_file.settings.reference = "";
        of_file.settings.camera = "orbit:azimuth=60,elevation=0,distance=4,target=0 0 0";
        const auto other = test::rendered(of_file);
        ASSERT_TRUE(other);
        EXPECT_GT(codes_rmse(a->display, other->display), 0.05);
    }
}

/// The square with an occlusion map that is black, lit by `env` and `lights`; its mean green.
double occluded(const support::TemporaryFolder& folder, double strength, const char* env,
                std::vector<std::string> lights) {
    test::Chart chart;
    const Json map{{"occlusionTexture",
                    {{"index", chart.texture({0, 90, 90}, {0, 90, 90})}, {"strength", strength}}}};
    Json primitive = chart.primitive(chart.material({0.5, 0.5, 0.5, 1}, map));
    primitive["attributes"]["TEXCOORD_0"] = chart.coordinates(0.5F, 0.5F);
    chart.place(primitive, 0.0);
    Request request = test::small_request(
        folder.write("occlusion.gltf", std::move(chart).finish().text()).string(), env);
    request.settings.size = {test::chart_columns * test::tile_px, test::chart_rows * test::tile_px};
    request.settings.light = std::move(lights);
    request.settings.shadows = "off";  // rays find their own occlusion
    const auto picture = test::rendered(request);
    return picture ? test::tile_mean(picture->display, 0, 1) : -1.0;
}

TEST(OcclusionMap, KeepsOffTheEnvironmentByItsRedAndNoLight) {
    const support::TemporaryFolder folder;
    EXPECT_NEAR(occluded(folder, 1.0, "furnace", {}), 0.0, 1.0);
    const double open = occluded(folder, 0.0, "furnace", {});
    EXPECT_GT(open, 100.0);
    // Half of the light, in codes of sRGB.
    EXPECT_NEAR(occluded(folder, 0.5, "furnace", {}),
                255.0 * static_cast<double>(math::srgb_from_linear(
                            0.5F * math::linear_from_srgb(static_cast<float>(open / 255.0)))),
                2.0);
    const std::vector<std::string> sun{"directional:azimuth=0,elevation=30,lux=3"};
    EXPECT_NEAR(occluded(folder, 1.0, "black", sun), occluded(folder, 0.0, "black", sun), 0.5);
}

}  // namespace
}  // namespace facet::render
