// Lights that are seen themselves, raster against reference.
// SPDX-License-Identifier: MIT
#include "support/rendered.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace facet::render {
namespace {

constexpr const char* lamps[] = {
    "rect:position=-1.4 1.6 0.6,target=0 0 0,width=1,height=0.8,nit=8",
    "disk:position=1.4 1.6 0.6,target=0 0 0,radius=0.4,nit=12",
    "sphere:position=1.2 1.2 0.6,radius=0.3,nit=12",
    "tube:position=0 1.8 0.4,target=0 0 0,width=1.6,radius=0.08,nit=30"};

Request lit(const std::string& scene, const std::string& lamp, const char* shadows) {
    Request request = test::small_request(scene, "black");
    tables::Settings& s = request.settings;
    s.camera = "orbit:azimuth=10,elevation=10,distance=6,target=0 0.6 0";
    s.shadows = shadows;
    s.light = {lamp};
    return request;
}

/// Radiance in nit, and how much of the picture is as bright as a lamp of that many.
struct Seen {
    double brightest = 0.0;
    double share = 0.0;
};
Seen seen(Request request, double nit) {
    request.want_linear = true;
    Seen out;
    const auto rendered = test::rendered(request);
    if (!rendered) return out;
    const auto values = rendered->layers.front().image.as<float>();
    for (std::size_t i = 0; i < values.size(); i += 4) {
        const auto green = static_cast<double>(values[i + 1]);
        out.brightest = std::max(out.brightest, green);
        if (green > 0.99 * nit) out.share += 4.0 / static_cast<double>(values.size());
    }
    return out;
}

/// Mean radiance of the ball, from near: lamps stand beside the picture's middle.
double middle_of(Request request) {
    request.want_linear = true;
    request.settings.camera = "orbit:azimuth=10,elevation=10";
    const auto rendered = test::rendered(request);
    if (!rendered) return 0.0;
    double sum = 0.0;
    const auto values = rendered->layers.front().image.as<float>();
    for (std::size_t y = 24; y < 36; ++y)
        for (std::size_t x = 34; x < 46; ++x)
            sum += static_cast<double>(values[(y * 80 + x) * 4 + 1]);
    return sum / 144.0;
}

TEST(VisibleLight, IsSeenInRasterAndReferenceAlike) {
    for (const std::string lamp : lamps)
        for (const char* const shadows : {"traced", "off"}) {
            Request request = lit("builtin:ball", lamp + ",visible=on", shadows);
            request.settings.reference = "64";
            request.settings.compare = true;
            EXPECT_LT(test::rmse_to_reference(request), 0.02) << lamp << ' ' << shadows;
        }
}

TEST(VisibleLight, HasItsRadianceAndIsNotThereUnlessAskedFor) {
    const std::string lamp = lamps[2];
    for (const char* const shadows : {"traced", "maps", "off"}) {
        const Seen on = seen(lit("builtin:ball", lamp + ",visible=on", shadows), 12.0);
        EXPECT_NEAR(on.brightest, 12.0, 1e-3) << shadows;
        // A ball of 0.3 m seen from some 5.6 m, 46 degrees high: 1.2 % of a picture of 4 : 3.
        EXPECT_GT(on.share, 0.005) << shadows;
        EXPECT_EQ(seen(lit("builtin:ball", lamp, shadows), 12.0).share, 0.0) << shadows;
    }
}

// Each lamp lights the ball with its shape in it as without. The last is a tube that the ball is
// seen along from its middle: maps of its light would show its side.
TEST(VisibleLight, KeepsItsOwnLightFromNothing) {
    std::vector<std::string> all(std::begin(lamps), std::end(lamps));
    all.emplace_back("tube:position=1.6 1.2 0.6,target=1.6 0 0.6,width=1.6,radius=0.08,nit=30");
    for (const std::string& lamp : all)
        for (const char* const shadows : {"traced", "maps", "off"}) {
            Request request = lit("builtin:ball", lamp, shadows);
            request.settings.quality = "draft";
            const double unseen = middle_of(request);
            request.settings.light = {lamp + ",visible=on"};
            EXPECT_GT(unseen, 0.01) << lamp;
            EXPECT_NEAR(middle_of(request) / unseen, 1.0, 0.01) << lamp << ' ' << shadows;
        }
}

// A panel between the sun and the ball.
TEST(VisibleLight, ShadesTheBallByRaysAndByMaps) {
    const std::string panel = "rect:position=0 2.5 0,target=0 9 0,width=3,height=3,nit=0";
    for (const char* const shadows : {"traced", "maps"}) {
        Request request = lit("builtin:ball", panel + ",visible=on", shadows);
        request.settings.light.push_back("directional:elevation=90,lux=9");
        const double shaded = seen(request, 1.0).brightest;
        request.settings.light.front() = panel;
        EXPECT_LT(shaded, 0.05 * seen(request, 1.0).brightest) << shadows;
    }
}

// Once by its own light and once as a thing that the probe sees would be twice.
TEST(VisibleLight, IsNoPartOfWhatAProbeSees) {
    Request request = lit("builtin:ball", std::string(lamps[0]) + ",visible=on", "off");
    request.settings.probe = "0 1.4 0";
    request.settings.set = {"material.*.metallic=0", "material.*.base_color=0.8 0.8 0.8"};
    const double seen = middle_of(request);
    request.settings.light = {lamps[0]};
    EXPECT_NEAR(seen / middle_of(request), 1.0, 0.02);
}

}  // namespace
}  // namespace facet::render
