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

}  // namespace
}  // namespace facet::render
