// A camera's faults and motion in pictures: raster and reference against closed forms.
// SPDX-License-Identifier: MIT
#include "math/color.h"
#include "scene/lens.h"
#include "support/rendered.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace facet::render {
namespace {

using test::radiance_of;

math::Vec3 at(const image::Image& image, std::uint32_t x, std::uint32_t y) {
    const auto v = image.as<float>();
    const std::size_t i = (std::size_t{y} * image.size.width + x) * 4;
    return {v[i], v[i + 1], v[i + 2]};
}

Request even_light(const std::string& reference) {
    Request request{.scene = "builtin:ball"};
    tables::Settings& s = request.settings;
    s.size = {96, 64};
    s.env = "furnace";
    s.camera = "orbit:azimuth=0,elevation=0,distance=1000";
    s.exposure = "1";
    s.quality = "draft";
    s.reference = reference;
    return request;
}

// Light is 1 nit everywhere, so the picture is what the lens leaves of it.
TEST(Camera, CornersAreDarkerByTheFourthPowerOfTheCosine) {
    for (const char* const reference : {"", "4"}) {
        Request request = even_light(reference);
        request.settings.fov = 53.13F;  // a 24 mm lens
        request.settings.vignette = "natural";
        const image::Image image = radiance_of(request);
        const float middle = at(image, 48, 32).y;
        for (const std::uint32_t x : {0U, 20U, 95U}) {
            const float tx = (static_cast<float>(x) + 0.5F - 48.0F) / 64.0F;
            const float ty = (0.5F - 32.0F) / 64.0F;
            const float expected = 1.0F / std::pow(1.0F + tx * tx + ty * ty, 2.0F);
            EXPECT_NEAR(at(image, x, 0).y / middle, expected, 0.004F) << x << " " << reference;
        }
    }
}

// The share of two equal disks that overlap, their middles d radii apart: (2 acos(d / 2) - d sqrt(1
// - d^2 / 4)) / pi.
TEST(Camera, TheBarrelCoversAWideApertureAsDisksOverlapAndANarrowOneNotAtAll) {
    for (const float f_number : {1.4F, 8.0F})
        for (const char* const reference : {"", "256"}) {
            Request request = even_light(reference);
            request.settings.size = {60, 40};
            request.settings.fov = 27.0F;
            request.settings.aperture = f_number;
            request.settings.samples = 256;
            const image::Image open = radiance_of(request);
            request.settings.vignette = "full";
            const image::Image full = radiance_of(request);
            const float half = std::tan(0.5F * 27.0F * math::pi / 180.0F);
            const float r = std::hypot(29.5F, 19.5F) / std::hypot(30.0F, 20.0F);
            const float tangent = half * std::hypot(29.5F, 19.5F) / 20.0F;
            const float natural = 1.0F / std::pow(1.0F + tangent * tangent, 2.0F);
            const float d = 0.8F * r;
            const float overlap =
                (2.0F * std::acos(d / 2.0F) - d * std::sqrt(1.0F - d * d / 4.0F)) / math::pi;
            EXPECT_NEAR(at(full, 0, 0).y / at(open, 0, 0).y,
                        natural * (f_number < 2.0F ? overlap : 1.0F), 0.02F)
                << f_number << " " << reference;
        }
}

/// Sums of columns [first, last).
double light_of(const image::Image& image, std::uint32_t first, std::uint32_t last) {
    double sum = 0.0;
    for (std::uint32_t y = 0; y < image.size.height; ++y)
        for (std::uint32_t x = first; x < last; ++x) sum += static_cast<double>(at(image, x, y).y);
    return sum;
}

// The camera turns while the shutter is open. What is narrower than its way spreads over it: along
// the streak's flat part a column gets the light of all, divided by the way in pixels, f tan(angle)
// to either side.
TEST(Camera, AMovingCameraDrawsStreaksOfTheLengthOfItsWay) {
    for (const char* const reference : {"", "256"}) {
        Request request{.scene = "builtin:ball"};
        tables::Settings& s = request.settings;
        s.size = {200, 40};
        s.env = "furnace";
        s.background = "none";
        s.exposure = "1";
        s.quality = "draft";
        s.samples = 256;
        s.reference = reference;
        s.camera = "orbit:azimuth=0,elevation=0,distance=40";
        s.fov = 20.0F;
        const double still = light_of(radiance_of(request), 0, 200);
        s.motion_blur = "turn=15";
        const image::Image moved = radiance_of(request);
        EXPECT_NEAR(light_of(moved, 0, 200) / still, 1.0, 0.02) << "none is lost" << reference;
        const double per_tangent = 20.0 / std::tan(10.0 * std::numbers::pi / 180.0);
        const double way_px = 2.0 * per_tangent * std::tan(7.5 * std::numbers::pi / 180.0);
        const double flat = light_of(moved, 94, 106) / 12.0;
        EXPECT_NEAR(light_of(moved, 0, 200) / flat, way_px, 1.0) << reference;
    }
}

TEST(Camera, ACameraThatDoesNotMoveHasTheSameBytes) {
    Request request = even_light("");
    request.settings.samples = 4;
    const image::Image still = radiance_of(request);
    request.settings.motion_blur = "turn=0";
    EXPECT_EQ(radiance_of(request).bytes, still.bytes);
}

// A picture of the environment alone, all around, is the environment: rows and columns as --env
// reads them.
TEST(Camera, APanoramaShowsTheEnvironmentAsItsFileHasIt) {
    for (const char* const reference : {"", "16"}) {
        Request request{.scene = "builtin:ball"};
        tables::Settings& s = request.settings;
        s.size = {128, 64};
        s.env = "sky";
        s.exposure = "1";
        s.quality = "draft";
        s.reference = reference;
        s.camera = "orbit:azimuth=0,elevation=0,distance=10000";
        s.projection = "panorama";
        const image::Image around = radiance_of(request);
        s.projection = "";
        s.fov = 90.0F;
        s.size = {64, 64};
        for (const auto& [azimuth, column] : {std::pair{0, 64U}, {90, 32U}, {270, 96U}}) {
            // Seen from azimuth 90 the eye looks to -x: a quarter of the picture to the left.
            s.camera = "orbit:azimuth=" + std::to_string(azimuth) + ",elevation=0,distance=10000";
            const image::Image ahead = radiance_of(request);
            for (const std::uint32_t row : {24U, 40U}) {
                const float latitude = (0.5F - (static_cast<float>(row) + 0.5F) / 64.0F) * math::pi;
                const auto y = static_cast<std::uint32_t>(32.0F - 32.0F * std::tan(latitude));
                const math::Vec3 a = at(around, column, row);
                const math::Vec3 b = at(ahead, 32, y);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(a[c] / b[c], 1.0F, 0.04F) << azimuth << " " << row << reference;
            }
        }
    }
}

// What a lens bends, raster and reference bend alike.
TEST(Camera, ABentPictureIsTheSameInRasterAndReference) {
    Request request{.scene = "builtin:ball"};
    tables::Settings& s = request.settings;
    s.size = {96, 64};
    s.tonemap = "none";
    s.env = "furnace";
    s.background = "#000000";
    s.distortion = 0.2F;
    s.aberration = 0.04F;
    s.reference = "64";
    s.compare = true;
    base::Log log;
    const auto rendered = render(request, log);
    ASSERT_TRUE(rendered) << base::to_line(rendered.error());
    EXPECT_LT(rendered->compared->rmse, 0.02);
}

/// What a picture's middle shows, linear.
double shown(Request request) {
    request.settings.depth = "16";
    request.settings.tonemap = "none";
    base::Log log;
    const auto rendered = render(request, log);
    if (!rendered) {
        ADD_FAILURE() << base::to_line(rendered.error());
        return 0.0;
    }
    const auto codes = rendered->display.as<std::uint16_t>();
    const std::size_t middle = (std::size_t{8} * 16 + 8) * 4;
    const auto linear = [&](std::size_t c) {
        return math::linear_from_srgb(static_cast<float>(codes[middle + c]) / 65535.0F);
    };
    return static_cast<double>(math::luminance({linear(0), linear(1), linear(2)}));
}

// A card that fills the picture. Automatic exposure shows it at 0.18. A meter that reads the light
// it reflects (L = 12.5 / 100 2^EV, ISO 2720) at 1 / (1.2 * 8) = 0.104; one that reads the light on
// it (E = 250 / 100 2^EV) shows a card of 18 % at 0.18 * 2.5 / (1.2 pi) = 0.119.
// A lens that hardly bends anything is exposed as one that does not: covered pixels are found in
// the view that is bent, rows of light with rows of depth.
TEST(Camera, ABentPictureIsExposedAsAStraightOne) {
    Request request{.scene = "builtin:spheres"};
    tables::Settings& s = request.settings;
    s.size = {128, 96};
    s.env = "sky";
    s.quality = "draft";
    const auto straight = test::rendered(request);
    s.distortion = 0.0001F;
    const auto bent = test::rendered(request);
    ASSERT_TRUE(straight && bent);
    EXPECT_NEAR(bent->exposure / straight->exposure, 1.0, 0.05);
}

TEST(Camera, AGreyCardIsExposedAsMetersSay) {
    Request request{.scene = "builtin:ball"};
    tables::Settings& s = request.settings;
    s.size = {16, 16};
    s.fov = 0.5F;
    s.env = "furnace";
    s.env_intensity = 700.0F;
    s.quality = "draft";
    const math::Vec3 nit = at(radiance_of(request), 8, 8);
    const double card_nit = static_cast<double>(math::luminance(nit));
    EXPECT_NEAR(shown(request), 0.18, 0.001);
    s.ev = static_cast<float>(std::log2(card_nit * 100.0 / 12.5));
    EXPECT_NEAR(shown(request), 0.104, 0.001);
    const double lux = card_nit * static_cast<double>(math::pi) / 0.18;
    s.ev = static_cast<float>(std::log2(lux * 100.0 / 250.0));
    EXPECT_NEAR(shown(request), 0.119, 0.001);
    // The same by aperture, shutter and ISO.
    s.aperture = 8.0F;
    s.iso = 100.0F;
    s.shutter = 64.0F / std::exp2(*s.ev);
    s.ev.reset();
    EXPECT_NEAR(shown(request), 0.119, 0.001);
}

}  // namespace
}  // namespace facet::render
