// Lights of a picture, raster against reference.
// SPDX-License-Identifier: MIT
#include "render/render.h"

#include <gtest/gtest.h>

namespace facet::render {
namespace {

// Lights with a size by linearly transformed cosines: on a lone ball there is no shadow but its
// own.
TEST(LightsWithoutRays, ThoseWithASizeAreAsTheReferenceHasThem) {
    for (const char* const light :
         {"rect:position=0 3 0,target=0 0 0,width=2,height=1,nit=20",
          "disk:position=2 3 1,target=0 0 0,radius=0.5,nit=30",
          "sphere:position=2 2 2,radius=0.5,nit=30",
          "tube:position=0 2.2 1.5,target=0 0 0,width=3,radius=0.1,nit=30",
          "rect:position=0 3 0,target=0 0 0,width=2,height=1,nit=20,range=4"}) {
        Request request{.scene = "builtin:ball"};
        tables::Settings& s = request.settings;
        s.size = {80, 60};
        s.env = "black";
        s.background = "none";
        s.tonemap = "none";
        s.exposure = "0.6";
        s.shadows = "off";
        s.light = {light};
        s.reference = "64";
        s.compare = true;
        base::Log log;
        const auto rendered = render(request, log);
        ASSERT_TRUE(rendered) << base::to_line(rendered.error());
        EXPECT_LT(rendered->compared->rmse, 0.02) << light;
    }
}

// The rasteriser takes the sun out of the sky, the reference does not.
TEST(Sun, OfATurnedSkyLightsAsItDoesInThePicture) {
    Request request{.scene = "builtin:ball"};
    tables::Settings& s = request.settings;
    s.size = {80, 60};
    s.env = "sky:sun_elevation=20";
    s.env_rotation = 70.0F;
    s.tonemap = "none";
    s.reference = "128";
    s.compare = true;
    for (const char* const shadows : {"off", "traced"}) {
        s.shadows = shadows;
        base::Log log;
        const auto rendered = render(request, log);
        ASSERT_TRUE(rendered) << base::to_line(rendered.error());
        EXPECT_LT(rendered->compared->rmse, 0.015) << shadows;
    }
}

// Looking at it: as bright as in the reference, which sees the picture itself.
TEST(Sun, IsSeenInTheBackground) {
    double sums[2] = {};
    for (const bool is_reference : {false, true}) {
        Request request{.scene = "builtin:ball", .want_linear = true};
        tables::Settings& s = request.settings;
        s.size = {160, 160};
        s.env = "sky:sun_elevation=0.5,sun_azimuth=180";
        s.camera = "orbit:azimuth=0,elevation=0,distance=1000";
        s.fov = 8.0F;
        s.exposure = "1";
        s.quality = "draft";
        s.samples = 16;
        s.reference = is_reference ? "16" : "";
        base::Log log;
        const auto rendered = render(request, log);
        ASSERT_TRUE(rendered) << base::to_line(rendered.error());
        const auto values = rendered->layers.front().image.as<float>();
        for (std::size_t i = 0; i < values.size(); i += 4)
            sums[is_reference ? 1 : 0] += static_cast<double>(values[i + 1]);
    }
    EXPECT_NEAR(sums[0] / sums[1], 1.0, 0.05);
}

}  // namespace
}  // namespace facet::render
