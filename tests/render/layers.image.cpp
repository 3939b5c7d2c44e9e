// Layers over a material's base, raster against reference.
// SPDX-License-Identifier: MIT
#include "support/rendered.h"

#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

namespace facet::render {
namespace {

Request layered_ball(std::vector<std::string> edits) {
    Request request{.scene = "builtin:ball"};
    tables::Settings& s = request.settings;
    s.size = {80, 60};
    s.env = "studio";
    s.background = "none";
    s.tonemap = "none";
    s.exposure = "0.5";
    s.set = std::move(edits);
    s.set.insert(s.set.end(), {"material.ball.base_color=0.5 0.02 0.02", "material.ball.metallic=0",
                               "material.ball.roughness=0.6"});
    return request;
}

TEST(Clearcoat, IsAsTheReferenceHasItInEveryLight) {
    struct Lit {
        const char* light;
        const char* env;
    };
    for (const Lit lit :
         {Lit{"", "studio"}, Lit{"directional:azimuth=40,elevation=50,lux=3", "black"},
          Lit{"rect:position=1.6 2.6 2.2,target=0 0.5 0,nit=60,width=1,height=0.5", "black"}})
        for (const char* const roughness : {"0.03", "0.1", "0.4"})
            for (const char* const shadows : {"traced", "off"}) {
                Request request =
                    layered_ball({"material.ball.clearcoat=1",
                                  fmt::format("material.ball.clearcoat_roughness={}", roughness)});
                request.settings.env = lit.env;
                if (*lit.light != '\0') request.settings.light = {lit.light};
                request.settings.shadows = shadows;
                request.settings.reference = "128";
                request.settings.compare = true;
                // Without rays the environment is a split sum: 0.026 at roughness 0.4.
                const double most = *shadows == 'o' ? 0.03 : 0.02;
                EXPECT_LT(test::rmse_to_reference(request), most)
                    << lit.env << ' ' << lit.light << " roughness " << roughness << ' ' << shadows;
            }
}

}  // namespace
}  // namespace facet::render
