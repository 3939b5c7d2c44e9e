// What --quality promises: how far each is from the reference.
// SPDX-License-Identifier: MIT
#include "render/render.h"

#include <gtest/gtest.h>

namespace facet::render {
namespace {

double rmse_of(const std::string& scene, const std::string& quality,
               const std::vector<std::string>& lights) {
    Request request{.scene = scene};
    tables::Settings& s = request.settings;
    s.size = {96, 54};
    s.quality = quality;
    s.tonemap = "none";
    s.background = "none";
    s.reference = "256";
    s.compare = true;
    s.no_file_lights = true;
    if (!lights.empty()) {
        s.env = "black";
        s.exposure = "1";
        s.light = lights;
    }
    base::Log log;
    const auto rendered = render(request, log);
    if (!rendered) {
        ADD_FAILURE() << base::to_line(rendered.error());
        return 1.0;
    }
    return rendered->compared->rmse;
}

// 256 samples of the reference, whose own noise is about 0.01 here; measured at 160x90: 0.043,
// 0.033 and 0.012 under the studio and under a sun, and 0.17 without rays.
TEST(Qualities, EachIsNearerToTheReferenceThanTheOneBefore) {
    const std::vector<std::string> sun = {"directional:azimuth=60,elevation=40,lux=3"};
    for (const auto& lights : {std::vector<std::string>{}, sun}) {
        const double draft = rmse_of("builtin:cornell", "draft", lights);
        const double standard = rmse_of("builtin:cornell", "standard", lights);
        const double final = rmse_of("builtin:cornell", "final", lights);
        EXPECT_LT(draft, 0.07);
        EXPECT_LT(standard, 0.045);
        EXPECT_LT(final, 0.03);
    }
}

}  // namespace
}  // namespace facet::render
