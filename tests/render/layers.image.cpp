// Layers over a material's base, raster against reference.
// SPDX-License-Identifier: MIT
#include "support/rendered.h"

#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

namespace facet::render {
namespace {

using test::every_light;
using test::Lit;

/// Of the ball in red plastic with `edits` over it.
double rmse(const Lit& by, const char* shadows, std::vector<std::string> edits) {
    Request request = test::small_request("builtin:ball", by.env);
    edits.insert(edits.end(), {"material.ball.base_color=0.5 0.02 0.02", "material.ball.metallic=0",
                               "material.ball.roughness=0.6"});
    request.settings.set = std::move(edits);
    if (*by.light != '\0') request.settings.light = {by.light};
    request.settings.shadows = shadows;
    request.settings.reference = "128";
    request.settings.compare = true;
    return test::rmse_to_reference(request);
}

TEST(Clearcoat, IsAsTheReferenceHasItInEveryLight) {
    for (const Lit& by : every_light)
        for (const char* const roughness : {"0.03", "0.1", "0.4"}) {
            const std::vector<std::string> edits{
                "material.ball.clearcoat=1",
                fmt::format("material.ball.clearcoat_roughness={}", roughness)};
            EXPECT_LT(rmse(by, "traced", edits), 0.02) << by.env << by.light << ' ' << roughness;
            // Without rays the environment is a split sum: 0.026 at roughness 0.4.
            EXPECT_LT(rmse(by, "off", edits), 0.03) << by.env << by.light << ' ' << roughness;
        }
}

TEST(Clearcoat, DimsWhatTheSurfaceEmits) {
    const std::vector<std::string> edits{
        "material.ball.emissive=1 0.6 0.3", "material.ball.clearcoat=1",
        "material.ball.clearcoat_roughness=0.4", "material.ball.specular=0"};
    const Lit dark{"", "black"};
    for (const char* const shadows : {"traced", "off"})
        EXPECT_LT(rmse(dark, shadows, edits), 0.004) << shadows;
}

TEST(Sheen, IsAsTheReferenceHasItInEveryLight) {
    for (const Lit& by : every_light)
        for (const char* const roughness : {"0.2", "0.5"}) {
            const std::vector<std::string> edits{
                "material.ball.sheen_color=0.8 0.8 0.9",
                fmt::format("material.ball.sheen_roughness={}", roughness)};
            EXPECT_LT(rmse(by, "traced", edits), 0.025) << by.env << by.light << ' ' << roughness;
        }
}

TEST(Sheen, UnderACoatOnAMetalIsAsTheReferenceHasIt) {
    const std::vector<std::string> edits{
        "material.ball.sheen_color=0.1 0.7 0.3", "material.ball.sheen_roughness=0.4",
        "material.ball.clearcoat=0.5", "material.ball.clearcoat_roughness=0.2"};
    for (const Lit& by : every_light)
        EXPECT_LT(rmse(by, "traced", edits), 0.025) << by.env << by.light;
}

}  // namespace
}  // namespace facet::render
