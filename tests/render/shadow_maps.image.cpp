// Shadows by maps against shadows by rays, and ambient visibility against the reference.
// SPDX-License-Identifier: MIT
#include "support/rendered.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace facet::render {
namespace {

/// Light that comes straight from the lights, by what finds its shadows: [height, width, 3].
image::Image direct_light(const std::string& scene, const std::string& light,
                          const std::string& shadows) {
    Request request{.scene = scene};
    tables::Settings& s = request.settings;
    s.size = {240, 135};
    s.samples = 4;
    s.env = "black";
    s.exposure = "1";
    s.no_file_lights = true;
    s.light = {light};
    s.shadows = shadows;
    s.aov = {"diffuse_direct"};
    auto rendered = test::rendered(request);
    return rendered ? std::move(rendered->layers.back().image)
                    : image::Image(s.size, 3, image::Sample::f32);
}

struct Mistakes {
    double mean = 0.0;  ///< difference, of that without any shadow
    double dark = 0.0;  ///< share of the pixels that are lit and shown dark: acne
    double lit = 0.0;   ///< share of the pixels that are dark and shown lit: shadows come off
};
Mistakes compare(const std::string& scene, const std::string& light) {
    const image::Image traced = direct_light(scene, light, "traced");
    const image::Image mapped = direct_light(scene, light, "maps");
    const image::Image open = direct_light(scene, light, "off");
    const auto t = traced.as<float>();
    const auto m = mapped.as<float>();
    const auto o = open.as<float>();
    Mistakes out;
    double without = 0.0;
    for (std::size_t i = 0; i < t.size(); i += 3) {
        out.mean += static_cast<double>(std::fabs(m[i] - t[i]));
        without += static_cast<double>(std::fabs(o[i] - t[i]));
        const float least = 0.05F * o[i] + 1e-4F;
        if (m[i] < 0.5F * t[i] - least) out.dark += 1.0;
        if (t[i] < 0.5F * m[i] - least) out.lit += 1.0;
    }
    const auto pixels = static_cast<double>(t.size() / 3);
    return {out.mean / std::max(without, 1e-9), out.dark / pixels, out.lit / pixels};
}

TEST(ShadowMaps, AreAsTheRaysHaveThem) {
    for (const char* const light :
         {"directional:azimuth=45,elevation=40,lux=3", "directional:azimuth=80,elevation=12,lux=3",
          "point:position=1.5 3 1.5,candela=30",
          "spot:position=2 3 3,target=0 0.5 0,outer=30,candela=40",
          "directional:azimuth=45,elevation=40,lux=3,angle=8"})
        for (const char* const scene : {"builtin:showcase", "builtin:cornell"}) {
            const Mistakes found = compare(scene, light);
            EXPECT_LT(found.mean, 0.2) << scene << ' ' << light;
            EXPECT_LT(found.dark, 0.004) << scene << ' ' << light;
            EXPECT_LT(found.lit, 0.03) << scene << ' ' << light;
        }
}

double error_of(const std::string& scene, const std::string& shadows) {
    Request request{.scene = scene};
    tables::Settings& s = request.settings;
    s.size = {160, 90};
    s.shadows = shadows;
    s.tonemap = "none";
    s.reference = "32";
    s.compare = true;
    return test::rmse_to_reference(request);
}

TEST(Occlusion, BringsTheEnvironmentsLightNearerToTheReference) {
    EXPECT_LT(error_of("builtin:showcase", "maps"), 0.9 * error_of("builtin:showcase", "off"));
    EXPECT_LT(error_of("builtin:spheres", "maps"), 1.05 * error_of("builtin:spheres", "off"));
}

TEST(Occlusion, LeavesALoneBallAsItIs) { EXPECT_LT(error_of("builtin:ball", "maps"), 0.015); }

}  // namespace
}  // namespace facet::render
