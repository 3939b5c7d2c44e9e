// The irradiance of an environment against closed forms.
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

// Independent closed forms of tests/data/sh_irradiance.json, with the environment's axis along each
// of x, y, z.
TEST(EnvironmentIrradiance, EqualsTheClosedFormsWhateverTheAxis) {
    using Radiance = std::function<float(float)>;
    const std::vector<std::pair<std::size_t, Radiance>> cases = {
        {1, [](float) { return 1.0F; }},
        {2, [](float c) { return c > 0.0F ? 1.0F : 0.0F; }},
        {4, [](float c) { return 1.0F + 0.5F * c; }},
        {5, [](float c) { return c * c; }},
        {6, [](float c) { return std::max(0.0F, c); }}};
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
                // Texels 6 degrees apart: between two, a cosine's chord is 0.12 % lower at most.
                EXPECT_NEAR(static_cast<double>(irradiance_over_pi(baked, n).x), expected, 3.5e-3)
                    << "column " << column << " axis " << axis << " cosine " << c;
            }
        }
}

// A parallel beam of normal irradiance 1 lights max(0, n.l); its edge is as sharp as texels are.
TEST(EnvironmentIrradiance, LoneSunLightsByTheCosineAndNothingBehindTheTerminator) {
    image::Image latlong({1024, 512}, 3, image::Sample::f32);
    for (std::size_t c = 0; c < 3; ++c) latlong.as<float>()[(256 * 1024 + 512) * 3 + c] = 1e5F;
    const double beam = 1e5 * 2.0 * pi / 1024 * pi / 512;  // illuminance facing it, up to 1e-5
    const BakedEnvironment baked = bake(latlong);
    for (int degrees = 0; degrees <= 180; degrees += 5) {
        const Vec3 n = math::direction_from(180.0F + static_cast<float>(degrees), 0.0F);
        const double cosine = std::max(0.0, std::cos(degrees * pi / 180.0));
        const double edge = std::abs(degrees - 90) < 10 ? 0.035 : 0.01;
        EXPECT_NEAR(static_cast<double>(irradiance_over_pi(baked, n).x) * pi / beam, cosine, edge)
            << degrees;
    }
}

}  // namespace
}  // namespace facet::frame
