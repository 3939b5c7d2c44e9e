// What light does behind coloured panes, clear balls and skins: raster against reference, and
// against what it is with rays. SPDX-License-Identifier: MIT
#include "scene/gltf_chart_geometry.h"
#include "support/rendered.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace facet::render {
namespace {

/// A white wall, and 1 m before it a red pane of 0.8 m.
std::string wall_and_pane() {
    test::Chart chart;
    chart.place(chart.primitive(chart.material({0.8, 0.8, 0.8, 1})), 0.0)["scale"] = {6, 6, 1};
    const std::size_t red = chart.material(
        {0.9, 0.05, 0.05, 1},
        {{"pbrMetallicRoughness", {{"roughnessFactor", 0}}},
         {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}});
    chart.place(chart.primitive(red), 1.0);
    for (test::Json& node : chart.d.json["nodes"]) {
        node["translation"][0] = 0;
        node["translation"][1] = 0;
    }
    chart.d.json["extensionsUsed"] = {"KHR_materials_transmission"};
    return std::move(chart).finish().text();
}

math::Vec3 mean_of(const image::Image& radiance) {
    const auto values = radiance.as<float>();
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < values.size(); i += 4)
        sum += glm::dvec3(values[i], values[i + 1], values[i + 2]);
    return math::Vec3(sum / static_cast<double>(radiance.size.pixels()));
}

TEST(ColoredGlass, ThrowsAColoredShadowInEveryQuality) {
    const support::TemporaryFolder folder;
    Request request =
        test::small_request(folder.write("pane.gltf", wall_and_pane()).string(), "black");
    request.settings.light = {"directional:azimuth=45,elevation=0,lux=4"};
    request.settings.reference = "64";
    const math::Vec3 truth = mean_of(test::radiance_of(request));
    EXPECT_GT(truth.x, 1.02F * truth.y) << "of a white wall: the pane and its shadow";
    request.settings.reference = {};
    for (const char* const quality : {"draft", "standard", "final"}) {
        request.settings.quality = quality;
        const math::Vec3 drawn = mean_of(test::radiance_of(request));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(drawn[c] / truth[c], 1.0F, 0.01F) << quality << ' ' << "rgb"[c];
    }
}

TEST(ClearGlass, ShowsTheDiscOfTheSkysSun) {
    Request request = test::small_request("builtin:ball", "sky:sun_elevation=15,sun_azimuth=180");
    for (const char* const edit :
         {"metallic=0", "base_color=1 1 1", "transmission=1", "roughness=0", "thickness_m=1"})
        request.settings.set.push_back(std::string("material.ball.") + edit);
    request.settings.camera = "orbit:azimuth=0,elevation=0";
    const auto brightest = [&] {
        const image::Image radiance = test::radiance_of(request);
        const auto values = radiance.as<float>();
        return *std::max_element(values.begin(), values.end());
    };
    const float drawn = brightest();
    request.settings.reference = "64";
    // A disc of about a pixel, by 16 and 64 places in it; the sky around it is below 1 nit.
    EXPECT_NEAR(drawn / brightest(), 1.0F, 0.35F);
    EXPECT_GT(drawn, 100.0F);
}

// Without rays no light is seen to come through: these have the colour that deep layers have.
TEST(DeepLayers, HaveTheirColorWithoutRaysToo) {
    for (const char* const preset : {"skin", "wax", "jade", "milk"}) {
        Request request = test::small_request("builtin:ball", "studio");
        request.settings.material = {std::string("ball=") + preset};
        request.settings.shadows = "traced";
        const math::Vec3 traced = mean_of(test::radiance_of(request));
        request.settings.shadows = "off";
        const math::Vec3 without = mean_of(test::radiance_of(request));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(without[c] / traced[c], 1.0F, 0.25F) << preset << ' ' << "rgb"[c];
    }
}

}  // namespace
}  // namespace facet::render
