// The irradiance of an environment against closed forms and published tables.
// SPDX-License-Identifier: MIT
#include "support/environment_bake.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace facet::frame {
namespace {

nlohmann::json table(const std::string& name) {
    std::ifstream file(std::string(FACET_SOURCE_DIR) + "/tests/data/" + name);
    return nlohmann::json::parse(file);
}

// Independent closed forms of tests/data/sh_irradiance.json that are nowhere negative (those are
// windowed), with the environment's axis along each
// of x, y, z.
TEST(EnvironmentIrradiance, NineCoefficientsEqualTheClosedFormsWhateverTheAxis) {
    using Radiance = std::function<float(float)>;
    const std::vector<std::pair<std::size_t, Radiance>> cases = {
        {1, [](float) { return 1.0F; }},
        {3, [](float c) { return c > 0.0F ? 1.0F : 0.0F; }},
        {4, [](float c) { return 1.0F + 0.5F * c; }},
        {5, [](float c) { return c * c; }}};
    const auto rows = table("sh_irradiance.json")["rows"];
    for (const auto& [column, radiance] : cases)
        for (int axis = 0; axis < 3; ++axis) {
            const auto along = [&, r = radiance](const Vec3& d) { return Vec3(r(d[axis])); };
            const BakedEnvironment baked = bake(picture(256, along));
            for (const auto& row : rows) {
                const auto c = row[0].get<float>();
                Vec3 n(0.0F);
                n[axis] = c;
                n[(axis + 1) % 3] = std::sqrt(1.0F - c * c);
                const double expected = row[column].get<double>() / pi;
                // Midpoint values of 256 rows: the edge of the half sky is half a row off at most,
                // 0.0025.
                EXPECT_NEAR(static_cast<double>(evaluate_irradiance(baked.irradiance_sh, n).x),
                            expected, 2.5e-3)
                    << "column " << column << " axis " << axis << " cosine " << c;
            }
        }
}

TEST(EnvironmentIrradiance, SunAloneIsNowhereNegativeAndKeepsItsMean) {
    image::Image latlong({256, 128}, 3, image::Sample::f32);
    const std::size_t sun = (std::size_t{40} * 256 + 100) * 3;
    latlong.as<float>()[sun] = 5e4F;  // red alone: windowing must look at every channel
    const BakedEnvironment baked = bake(latlong);
    const double omega = 2.0 * pi / 256 * pi / 128 * std::sin(40.5 / 128 * pi);
    EXPECT_NEAR(static_cast<double>(baked.irradiance_sh[0].x), 5e4 * omega / (4.0 * pi), 1e-3);
    const float least_allowed = -1e-3F * baked.irradiance_sh[0].x;  // between the probed directions
    for (int elevation = -90; elevation <= 90; elevation += 5)
        for (int azimuth = 0; azimuth < 360; azimuth += 5) {
            const Vec3 n =
                math::direction_from(static_cast<float>(azimuth), static_cast<float>(elevation));
            EXPECT_GE(evaluate_irradiance(baked.irradiance_sh, n).x, least_allowed);
        }
}

// Reference: 9 coefficients of a parallel beam of normal irradiance 1 have their least value
// -0.0396 where the cosine is -8/15 (Ramamoorthi & Hanrahan 2001), their mean 1/4 and their largest
// value 1.0625.
TEST(EnvironmentIrradiance, LoneSunKeepsTheShareOfItsBandsThatLeavesTheLeastValueAtZero) {
    image::Image latlong({1024, 512}, 3, image::Sample::f32);
    for (std::size_t c = 0; c < 3; ++c) latlong.as<float>()[(256 * 1024 + 512) * 3 + c] = 1e5F;
    const double beam = 1e5 * 2.0 * pi / 1024 * pi / 512;  // illuminance facing it, up to 1e-5
    const double kept = 0.25 / (0.25 + 0.0396);
    const Vec3 facing = evaluate_irradiance(bake(latlong).irradiance_sh, {0.0F, 0.0F, -1.0F});
    EXPECT_NEAR(static_cast<double>(facing.x) * pi / beam, 0.25 + kept * 0.8125, 2e-3);
}

TEST(EnvironmentIrradiance, WindowLeavesWhatIsNowhereNegativeUnchanged) {
    const BakedEnvironment baked =
        bake(picture(64, [](const Vec3& d) { return Vec3(1.0F + 0.9F * d.y); }));
    const auto again = windowed(baked.irradiance_sh);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(again[i], baked.irradiance_sh[i]);
    EXPECT_NEAR(baked.irradiance_sh[1].x, 0.6F, 1e-4F);  // 0.9 times A_1 / pi = 2/3
}

}  // namespace
}  // namespace facet::frame
