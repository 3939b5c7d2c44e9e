// What explain says of a pixel adds up to the pixel that render draws.
// SPDX-License-Identifier: MIT
#include "explain/explain.h"

#include "base/texts.h"
#include "explain/told.h"
#include "scene/animation_fixture.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace facet::explain {
namespace {

render::Request request_of(const std::string& scene, const std::string& env) {
    render::Request request{.scene = scene, .settings = {}};
    request.settings.size = {160, 90};
    request.settings.env = env;
    request.settings.samples = 4;
    request.settings.light = {"directional:name=sun,azimuth=40,elevation=35,lux=3",
                              "point:name=lamp,position=0.4 0.8 1.5,candela=3,range=4",
                              "spot:position=-0.5 1 1,target=0 0 0,candela=2,inner=10,outer=25"};
    return request;
}

struct Case {
    const char* scene;
    const char* env;
    const char* brdf;
};
class Explain : public testing::TestWithParam<Case> {};

void expect_sums(render::Request request) {
    std::vector<PixelRequest> pixels;
    std::mt19937 random(7);
    for (int i = 0; i < 180; ++i)
        pixels.push_back({static_cast<std::uint32_t>(random() % 160),
                          static_cast<std::uint32_t>(random() % 90)});
    base::Log log;
    const auto explained = explain(request, pixels, log, {});
    ASSERT_TRUE(explained) << base::to_line(explained.error());
    request.want_linear = true;
    const auto rendered = render::render(request, log);
    ASSERT_TRUE(rendered) << base::to_line(rendered.error());
    EXPECT_NEAR(explained->exposure, rendered->exposure, rendered->exposure * 1e-6);
    const auto values = rendered->layers.front().image.as<float>();
    for (const Pixel& pixel : explained->pixels)
        for (int c = 0; c < 3; ++c) {
            const auto truth = static_cast<double>(
                values[(std::size_t{pixel.y} * 160 + pixel.x) * 4 + static_cast<std::size_t>(c)]);
            EXPECT_NEAR(pixel.sum[c], truth, std::max(std::fabs(truth), 1e-6) * 1e-4)
                << pixel.x << "," << pixel.y;
        }
}

TEST_P(Explain, AddsUpToThePixelsOfThePicture) {
    render::Request request = request_of(GetParam().scene, GetParam().env);
    request.settings.brdf = GetParam().brdf;
    expect_sums(request);
}
TEST(ExplainPixel, AddsUpWhereSomethingMovesMeanwhile) {
    const support::TemporaryFolder folder;
    test::Document d = test::moving();
    d.json["materials"] = {{{"doubleSided", true}}};
    test::primitive(d)["material"] = 0;
    render::Request request = request_of(folder.write("a.gltf", d.text()).string(), "studio");
    request.settings.camera = "orbit:azimuth=0,elevation=0,distance=4,target=2 0.5 0";
    request.settings.time = 1.0F;
    request.settings.shutter = 0.5F;
    for (const char* const shadows : {"traced", "maps", "off"}) {
        request.settings.shadows = shadows;
        expect_sums(request);
    }
}
INSTANTIATE_TEST_SUITE_P(BundledScenes, Explain,
                         testing::Values(Case{"builtin:showcase", "studio", ""},
                                         Case{"builtin:spheres", "sky", "lecture"},
                                         Case{"builtin:furnace", "furnace",
                                              "multiscatter=kulla-conty"},
                                         Case{"builtin:cornell", "black", ""},
                                         Case{"builtin:ball", "studio", "distribution=beckmann"},
                                         Case{"builtin:showcase", "overcast", "multiscatter=off"}));

TEST(ExplainPixel, TellsWhatComesThroughGlassAndSkin) {
    for (const char* const preset : {"clear_glass", "skin"}) {
        render::Request request = request_of("builtin:ball", "studio");
        request.settings.material = {std::string("ball=") + preset};
        expect_sums(request);
        base::Log log;
        const auto explained = explain(request, {{80, 45}}, log, {});
        ASSERT_TRUE(explained) << base::to_line(explained.error());
        const auto surface = json_of(*explained, explained->pixels[0])["samples"][0]["surface"];
        for (const std::size_t c : {0U, 1U, 2U}) {
            EXPECT_GT(surface["from_far_side_nit"][c], 0.1) << preset;
            EXPECT_GT(surface["balance"]["gone_through"][c], 0.9) << preset;
            EXPECT_EQ(surface["balance"]["absorbed"][c], 0.0) << preset;
        }
        const auto texts = base::Texts::load("en");
        ASSERT_TRUE(texts);
        const std::string tree = tree_of(*explained, explained->pixels[0], *texts);
        EXPECT_NE(tree.find("from behind the surface"), std::string::npos) << tree;
    }
}

TEST(ExplainPixel, IsSaidInBothLanguagesAndAsJson) {
    base::Log log;
    const auto explained =
        explain(request_of("builtin:ball", "studio"), {{80, 45}, {0, 0}, {80, 45}}, log, {});
    ASSERT_TRUE(explained) << base::to_line(explained.error());
    ASSERT_EQ(explained->pixels.size(), 3U);
    const auto first = json_of(*explained, explained->pixels[0]);
    EXPECT_EQ(first["pixel"][0], 80);
    EXPECT_EQ(first["samples"].size(), 4U);
    EXPECT_EQ(first["samples"][0]["surface"]["material"], "ball");
    EXPECT_EQ(first["samples"][0]["surface"]["lights"].size(), 3U);
    EXPECT_EQ(first["samples"][0]["surface"]["lights"][0]["name"], "sun");
    EXPECT_EQ(first["sum"], json_of(*explained, explained->pixels[2])["sum"]) << "asked for twice";
    const auto corner = json_of(*explained, explained->pixels[1]);
    EXPECT_FALSE(corner["samples"][0].contains("surface"));
    EXPECT_TRUE(corner["samples"][0].contains("background_nit"));
    for (const std::string_view language : base::languages) {
        const auto texts = base::Texts::load(language);
        ASSERT_TRUE(texts);
        for (const Pixel& pixel : explained->pixels) {
            const std::string tree = tree_of(*explained, pixel, *texts);
            EXPECT_EQ(tree.find("explain."), std::string::npos) << tree;
            EXPECT_NE(tree.find("pbr-neutral"), std::string::npos) << tree;
        }
    }
}

TEST(ExplainPixel, RefusesWhatIsOutsideAndWhatIsNoRaster) {
    base::Log log;
    const auto outside = explain(request_of("builtin:ball", "studio"), {{160, 0}}, log, {});
    ASSERT_FALSE(outside);
    EXPECT_EQ(outside.error().code, base::ErrorCode::usage);
    EXPECT_NE(outside.error().what.find("0 to 159"), std::string::npos) << outside.error().what;
    render::Request traced = request_of("builtin:ball", "studio");
    traced.settings.reference = "4";
    EXPECT_FALSE(explain(traced, {{0, 0}}, log, {}));
    render::Request region = request_of("builtin:ball", "studio");
    region.settings.region = "40,20,50x50";
    EXPECT_FALSE(explain(region, {{39, 30}}, log, {}));
    EXPECT_TRUE(explain(region, {{40, 20}}, log, {}));
}

}  // namespace
}  // namespace facet::explain
