// The sun of an environment, apart from the rest.
// SPDX-License-Identifier: MIT
#include "scene/sun.h"

#include "math/color.h"
#include "scene/environment_paint.h"

#include <gtest/gtest.h>

namespace facet::scene {
namespace {

Environment environment(const std::string& spec) {
    base::ThreadPool pool(2);
    base::Warnings warnings;
    auto loaded = load_environment(spec, {}, pool, warnings);
    EXPECT_TRUE(loaded) << spec;
    return loaded ? *loaded : Environment{};
}

/// Radiance times solid angle and direction, summed: what a picture lights its middle with.
Vec3 flux(const image::Image& picture) {
    const LatLong map(picture.size);
    const auto values = picture.as<float>();
    Vec3 sum(0.0F);
    for (std::size_t i = 0; i < picture.size.pixels(); ++i)
        sum += map.direction(i % picture.size.width, i / picture.size.width) *
               (math::luminance({values[i * 3], values[i * 3 + 1], values[i * 3 + 2]}) *
                map.solid_angle_sr(i / picture.size.width));
    return sum;
}

TEST(Sun, OfTheSkyIsWhereItWasPaintedAndNothingIsLost) {
    const Environment sky = environment("sky:sun_elevation=30,sun_azimuth=90");
    const SplitEnvironment split = split_sun(sky);
    ASSERT_TRUE(split.sun);
    const Vec3 to_sun = -split.sun->direction;
    EXPECT_NEAR(to_sun.x, std::cos(glm::radians(30.0F)), 2e-3F);
    EXPECT_NEAR(to_sun.y, 0.5F, 2e-3F);
    EXPECT_NEAR(to_sun.z, 0.0F, 5e-3F);
    const Vec3 whole = flux(*sky.latlong);
    const Vec3 parts = flux(*split.rest.latlong) + to_sun * split.sun->intensity;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(parts[c], whole[c], 2e-3F * math::length(whole));
    EXPECT_LT(split.sun->angle_rad, glm::radians(2.0F));
    EXPECT_TRUE(split.sun->of_environment);
    EXPECT_FALSE(split_sun(split.rest).sun) << "there is no second one";
}

TEST(Sun, IsNotSeenInPanelsEvenLightOrNone) {
    for (const char* const name : {"studio", "overcast", "furnace", "black"}) {
        const Environment room = environment(name);
        const SplitEnvironment split = split_sun(room);
        EXPECT_FALSE(split.sun) << name;
        EXPECT_EQ(split.rest.latlong, room.latlong) << name;
    }
}

TEST(Sun, TurnsWithItsEnvironmentCounterClockwiseSeenFromAbove) {
    Light sun{.intensity = 2.0F, .direction = {0.0F, 0.0F, 1.0F}};  // it stands at -z
    const Light turned = turned_sun(sun, 90.0F, 3.0F);
    EXPECT_NEAR(-turned.direction.x, -1.0F, 1e-6F);
    EXPECT_NEAR(turned.intensity, 6.0F, 1e-6F);
}

}  // namespace
}  // namespace facet::scene
