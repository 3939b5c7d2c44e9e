// Shadows on the ground, raster against reference.
// SPDX-License-Identifier: MIT
#include "render/render.h"

#include <gtest/gtest.h>

#include <cmath>

namespace facet::render {
namespace {

Request ball_on_the_ground() {
    Request request{.scene = "builtin:ball", .want_linear = true};
    tables::Settings& s = request.settings;
    s.size = {96, 64};
    s.camera = "orbit:azimuth=20,elevation=30,distance=6";
    s.exposure = "1";
    s.ground = "shadow";
    return request;
}

Rendered rendered(const Request& request) {
    base::Log log;
    auto out = render(request, log);
    if (!out) ADD_FAILURE() << base::to_line(out.error());
    return out ? std::move(*out) : Rendered{};
}

/// Root of the mean squared difference of the channels, where neither is over 4 nit.
double difference(const Rendered& a, const Rendered& b) {
    const auto x = a.layers.front().image.as<float>();
    const auto y = b.layers.front().image.as<float>();
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
        sum += std::pow(std::min(x[i], 4.0F) - std::min(y[i], 4.0F), 2.0);
    return std::sqrt(sum / static_cast<double>(x.size()));
}

TEST(Ground, CatchesShadowsAsInTheReference) {
    for (const char* const background : {"env", "none"}) {
        Request request = ball_on_the_ground();
        request.settings.background = background;
        request.settings.env = "furnace";
        request.settings.light = {"directional:azimuth=60,elevation=40,lux=3",
                                  "rect:position=-2 2 1,target=0 0 0,width=1,height=1,nit=4"};
        const Rendered raster = rendered(request);
        request.settings.reference = "64";
        EXPECT_LT(difference(raster, rendered(request)), 0.03) << background;
    }
}

TEST(Ground, IsNothingWhereTheSceneChangesNothing) {
    Request request = ball_on_the_ground();
    request.settings.env = "black";
    request.settings.background = "none";
    request.settings.light = {"directional:azimuth=0,elevation=89,lux=3"};
    for (const char* const reference : {"", "4"}) {
        request.settings.reference = reference;
        const Rendered picture = rendered(request);
        const auto values = picture.layers.front().image.as<float>();
        // The first row shows far ground, and the middle of the last the shadow's edge or the ball.
        for (std::size_t x = 0; x < 96; ++x) EXPECT_NEAR(values[x * 4 + 3], 0.0F, 1e-4F) << x;
        double covered = 0.0;
        for (std::size_t i = 3; i < values.size(); i += 4)
            covered += static_cast<double>(values[i]);
        request.settings.ground = "off";
        const Rendered without = rendered(request);
        request.settings.ground = "shadow";
        for (std::size_t i = 3; i < values.size(); i += 4)
            covered -= static_cast<double>(without.layers.front().image.as<float>()[i]);
        EXPECT_GT(covered, 50.0) << reference;
    }
}

/// Sum of what the picture covers, in pixels.
double coverage(const Request& request) {
    const Rendered picture = rendered(request);
    double sum = 0.0;
    const auto values = picture.layers.front().image.as<float>();
    for (std::size_t i = 3; i < values.size(); i += 4) sum += static_cast<double>(values[i]);
    return sum;
}

// A long shadow away from the eye: the far plane lies just behind the ball.
TEST(Ground, GoesOnBeyondTheFarPlane) {
    Request request = ball_on_the_ground();
    request.settings.camera = "orbit:azimuth=20,elevation=25";
    request.settings.env = "black";
    request.settings.background = "none";
    request.settings.light = {"directional:azimuth=20,elevation=12,lux=3"};
    for (const char* const reference : {"", "8"}) {
        request.settings.reference = reference;
        request.settings.ground = "shadow";
        const double with = coverage(request);
        request.settings.ground = "off";
        EXPECT_GT(with - coverage(request), 50.0) << reference;
    }
}

TEST(Ground, NeedsAHeight) {
    Request request = ball_on_the_ground();
    base::Log log;
    for (const char* const text : {"shadow:", "shadow:high", "on", "shadow:nan"}) {
        request.settings.ground = text;
        EXPECT_FALSE(render(request, log)) << text;
    }
}

}  // namespace
}  // namespace facet::render
