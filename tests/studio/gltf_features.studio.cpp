// The studio shows every feature of glTF that `facet render` does: one chart, the same picture.
// What each tile is without its feature is seen in tests/render/gltf_features.image.cpp.
// SPDX-License-Identifier: MIT
#include "scene/gltf_chart.h"
#include "studio/run_script.h"
#include "support/picture.h"
#include "support/process.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

namespace facet::studio {
namespace {

const std::vector<std::string>& chart_options() {
    static const std::vector<std::string> options{
        "--env",
        "furnace",
        "--light",
        "directional:azimuth=30,elevation=40,lux=6",
        "--samples",
        "4",
        "--exposure",
        "0.5",
        "--tonemap",
        "none",
        "--variant",
        "green",
        "--size",
        fmt::format("{}x{}", test::chart_columns * test::tile_px,
                    test::chart_rows * test::tile_px)};
    return options;
}

/// Share of the window's pixels that are plainly green: the chart's colour and nothing else's.
double green_share(const image::Image& window) {
    const auto codes = window.as<std::uint8_t>();
    const std::size_t count = codes.size() / window.channels;
    std::size_t green = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto* const p = &codes[i * window.channels];
        green += p[1] > 60 && p[1] > 2 * p[0] && p[1] > 2 * p[2] ? 1U : 0U;
    }
    return static_cast<double>(green) / static_cast<double>(count);
}

TEST(StudioFeatures, TheChartIsThatOfTheCommandAndIsSeenInTheWindow) {
    const support::TemporaryFolder folder;
    folder.write("chart.gltf", test::feature_chart(test::Shown::with).text());
    const support::Ran shown =
        test::run_script(folder, "chart.gltf", "1240x640",
                         "wait\nshot window.png\nsave studio.png\nwait\n", chart_options());
    ASSERT_EQ(shown.exit, 0) << shown.err;
    std::vector<std::string> render{"render", "chart.gltf", "-o", "command.png"};
    render.insert(render.end(), chart_options().begin(), chart_options().end());
    const support::Ran ran = support::facet(render, {.folder = folder.path()});
    ASSERT_EQ(ran.exit, 0) << ran.err;
    EXPECT_TRUE(support::text_of(folder / "studio.png") ==
                support::text_of(folder / "command.png"));
    const image::Image picture = support::picture(folder / "studio.png");
    const std::vector<test::Tile> tiles = test::chart_tiles();
    for (std::size_t t = 0; t < tiles.size(); ++t)
        EXPECT_GT(test::tile_mean(picture, t, 1), 1.3 * test::tile_mean(picture, t, 0))
            << tiles[t].name;
    // Tiles of 66 x 66 pixels in a window of 1240 x 640, one of which is as red as green.
    EXPECT_GT(green_share(support::picture(folder / "window.png")),
              (static_cast<double>(tiles.size()) - 1.0) * 66.0 * 66.0 / (1240.0 * 640.0) * 0.95);
}

/// Share of the window's pixels that are much darker in `a` than in `b`.
double darker_share(const image::Image& a, const image::Image& b) {
    const auto p = a.as<std::uint8_t>();
    const auto q = b.as<std::uint8_t>();
    EXPECT_EQ(p.size(), q.size());
    std::size_t darker = 0;
    for (std::size_t i = 1; i < std::min(p.size(), q.size()); i += a.channels)
        darker += p[i] + 100 < q[i] ? 1U : 0U;
    return static_cast<double>(darker * a.channels) / static_cast<double>(p.size());
}

TEST(StudioFeatures, AnOcclusionMapKeepsTheEnvironmentOffInTheWindow) {
    const support::TemporaryFolder folder;
    test::Chart chart;
    const test::Json map{
        {"name", "hidden"},
        {"occlusionTexture", {{"index", chart.texture({0, 90, 90}, {0, 90, 90})}}}};
    test::Json primitive = chart.primitive(chart.material({0.5, 0.5, 0.5, 1}, map));
    primitive["attributes"]["TEXCOORD_0"] = chart.coordinates(0.5F, 0.5F);
    chart.place(primitive, 0.0);
    folder.write("map.gltf", std::move(chart).finish().text());
    // Rays would find their own occlusion.
    const std::vector<std::string> options{"--env",     "furnace", "--shadows",  "off",
                                           "--samples", "2",       "--exposure", "0.5",
                                           "--tonemap", "none",    "--size",     "96x64"};
    const support::Ran shown =
        test::run_script(folder, "map.gltf", "1240x640",
                         "wait\nshot window.png\nsave studio.png\nwait\n"
                         "set material.hidden.ao_strength 0\nwait\nshot open.png\n",
                         options);
    ASSERT_EQ(shown.exit, 0) << shown.err;
    EXPECT_NEAR(test::tile_mean(support::picture(folder / "studio.png"), 0, 1), 0.0, 1.0);
    // 0.8 of a tile of 66 x 66 pixels.
    EXPECT_GT(darker_share(support::picture(folder / "window.png"),
                           support::picture(folder / "open.png")),
              0.64 * 66.0 * 66.0 / (1240.0 * 640.0) * 0.9);
}

}  // namespace
}  // namespace facet::studio
