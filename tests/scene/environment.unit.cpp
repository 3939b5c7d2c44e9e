// Computed environments: their levels, their conventions, and what is refused.
// SPDX-License-Identifier: MIT
#include "scene/environment.h"

#include "base/file.h"
#include "image/write.h"
#include "math/color.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace facet::scene {
namespace {

using math::Vec3;
using std::numbers::pi;

struct Loaded {
    Environment environment;
    base::Warnings warnings;
};
Loaded load(const std::string& spec) {
    base::ThreadPool pool(2);
    Loaded out;
    auto environment = load_environment(spec, base::Limits{}, pool, out.warnings);
    EXPECT_TRUE(environment) << spec << ": "
                             << (environment ? "" : base::to_line(environment.error()));
    if (environment) out.environment = std::move(*environment);
    return out;
}
base::Error refusal(const std::string& spec) {
    base::ThreadPool pool(1);
    base::Warnings warnings;
    const auto environment = load_environment(spec, base::Limits{}, pool, warnings);
    EXPECT_FALSE(environment) << spec;
    return environment ? base::Error{} : environment.error();
}
Vec3 pixel(const Environment& environment, std::size_t column, std::size_t row) {
    const auto values = environment.latlong->as<float>();
    const float* p = values.data() + (row * environment.latlong->size.width + column) * 3;
    return {p[0], p[1], p[2]};
}
/// Sum over the sphere of luminance times solid angle times `weight(direction)`.
template <class Weight>
double integral(const Environment& environment, const Weight& weight) {
    const auto [width, height] = environment.latlong->size;
    double sum = 0.0;
    for (std::uint32_t y = 0; y < height; ++y) {
        const double theta = (y + 0.5) / height * pi;
        const double solid_angle =
            2.0 * std::sin(theta) * std::sin(0.5 * pi / height) * 2.0 * pi / width;
        for (std::uint32_t x = 0; x < width; ++x) {
            const double phi = ((x + 0.5) / width - 0.5) * 2.0 * pi;
            const Vec3 d(std::sin(phi) * std::sin(theta), std::cos(theta),
                         -std::cos(phi) * std::sin(theta));
            sum += static_cast<double>(math::luminance(pixel(environment, x, y))) * solid_angle *
                   weight(d);
        }
    }
    return sum;
}
double mean_nit(const Environment& environment) {
    return integral(environment, [](const Vec3&) { return 1.0; }) / (4.0 * pi);
}
/// Direction of the brightest pixel.
Vec3 brightest(const Environment& environment) {
    const auto [width, height] = environment.latlong->size;
    float most = -1.0F;
    Vec3 out(0.0F);
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            if (pixel(environment, x, y).y <= most) continue;
            most = pixel(environment, x, y).y;
            const double theta = (y + 0.5) / height * pi;
            const double phi = ((x + 0.5) / width - 0.5) * 2.0 * pi;
            out = {std::sin(phi) * std::sin(theta), std::cos(theta),
                   -std::cos(phi) * std::sin(theta)};
        }
    return out;
}

TEST(Environment, FurnaceIsOneNitInEveryPixelAndBlackIsNothing) {
    const Environment furnace = load("furnace").environment;
    for (const float value : furnace.latlong->as<float>()) ASSERT_EQ(value, 1.0F);
    const Environment black = load("black").environment;
    for (const float value : black.latlong->as<float>()) ASSERT_EQ(value, 0.0F);
}

TEST(Environment, StudioIsFiniteNeutralAndAboutOneNitOnAverage) {
    const Environment studio = load("studio").environment;
    EXPECT_EQ(studio.latlong->size, (math::Extent{1024, 512}));
    EXPECT_NEAR(mean_nit(studio), 1.2, 0.3);
    Vec3 sum(0.0F);
    for (std::size_t y = 0; y < 512; ++y)
        for (std::size_t x = 0; x < 1024; ++x) {
            const Vec3 nit = pixel(studio, x, y);
            ASSERT_TRUE(nit.x > 0.1F && nit.x < 30.0F && nit.y > 0.1F && nit.z > 0.1F);
            sum += nit * std::sin(static_cast<float>((static_cast<double>(y) + 0.5) / 512.0 * pi));
        }
    EXPECT_NEAR(sum.x / sum.y, 1.0F, 0.02F);
    EXPECT_NEAR(sum.z / sum.y, 1.0F, 0.02F);
}

TEST(Environment, StudioLightsTheUpperLeftOfTheDefaultCameraMost) {
    const Environment studio = load("studio").environment;
    const Vec3 key = brightest(studio);
    const Vec3 right(std::cos(35.0 / 180.0 * pi), 0.0,
                     -std::sin(35.0 / 180.0 * pi));  // of azimuth 35
    EXPECT_LT(math::dot(key, right), -0.3F);
    EXPECT_GT(key.y, 0.3F);
}

// Moon & Spencer: horizon a third of the zenith, horizontal illuminance 7 pi / 9 times the zenith's
// luminance.
TEST(Environment, OvercastSkyHasItsZenithHorizonAndIlluminance) {
    const Environment overcast = load("overcast").environment;
    const std::uint32_t height = overcast.latlong->size.height;
    EXPECT_NEAR(pixel(overcast, 0, 0).y, 1.0F, 1e-3F);
    EXPECT_NEAR(pixel(overcast, 5, height / 2 - 1).y, 1.0F / 3.0F, 0.01F);
    const double lux =
        integral(overcast, [](const Vec3& d) { return std::max(static_cast<double>(d.y), 0.0); });
    EXPECT_NEAR(lux, 7.0 * pi / 9.0, 2e-3);
}

TEST(Environment, SunStandsWhereItsAnglesSay) {
    const Vec3 sun = brightest(load("sky:sun_azimuth=60,sun_elevation=40").environment);
    const Vec3 expected(0.66341395F, 0.64278761F, 0.38302222F);
    EXPECT_GT(math::dot(sun, expected), std::cos(0.01F));  // a pixel and a half
    EXPECT_GT(brightest(load("sky:sun-elevation=90").environment).y, 0.999F);
}

// The sky around it gives what its neighbours do; the rest of a disc of 2 degrees is the sun's,
// whose illuminance the atmosphere's transmittance times 13.38 lux (1/10000 of 133.8 klux) bounds.
TEST(Environment, SunGivesThePartOfTheSunlightThatTheAirLeavesAndFitsIntoHalfFloats) {
    for (const char* spec :
         {"sky", "sky:sun_elevation=0", "sky:sun_elevation=89.9,turbidity=1.9"}) {
        const Environment sky = load(spec).environment;
        const Vec3 sun = brightest(sky);
        const double lux = integral(sky, [&](const Vec3& d) {
            return math::dot(d, sun) > std::cos(0.02F) ? static_cast<double>(math::dot(d, sun))
                                                       : 0.0;
        });
        EXPECT_LT(lux, 13.38) << spec;
        EXPECT_GT(lux, spec == std::string("sky:sun_elevation=0") ? 0.0 : 5.0) << spec;
        for (const float nit : sky.latlong->as<float>())
            ASSERT_TRUE(nit >= 0.0F && nit < 65504.0F) << spec;
    }
}

TEST(Environment, ClearSkyIsBlueOppositeTheSunAndHazeMakesItPaler) {
    const Environment clear = load("sky:sun_azimuth=0,sun_elevation=30,turbidity=2").environment;
    const Environment hazy = load("sky:sun_azimuth=0,sun_elevation=30,turbidity=8").environment;
    const Vec3 a = pixel(clear, 512, 128);  // towards -z, 45 degrees up
    const Vec3 b = pixel(hazy, 512, 128);
    EXPECT_GT(a.z / a.x, 2.0F);
    EXPECT_LT(b.z / b.x, a.z / a.x);
}

// E times albedo over pi, with E the horizontal illuminance of sky and sun as the picture has them.
TEST(Environment, GroundOfTheSkyReflectsItsAlbedo) {
    const Environment sky = load("sky:ground_albedo=0.5").environment;
    const double lux =
        integral(sky, [](const Vec3& d) { return std::max(static_cast<double>(d.y), 0.0); });
    const double found = static_cast<double>(math::luminance(pixel(sky, 100, 400)));
    EXPECT_NEAR(found / (lux * 0.5 / pi), 1.0, 0.02);
}

TEST(Environment, BytesDoNotDependOnTheNumberOfThreads) {
    base::ThreadPool one(1);
    base::ThreadPool four(4);
    base::Warnings warnings;
    for (const char* spec : {"studio", "sky"}) {
        const auto a = load_environment(spec, base::Limits{}, one, warnings);
        const auto b = load_environment(spec, base::Limits{}, four, warnings);
        ASSERT_TRUE(a && b);
        EXPECT_EQ(a->latlong->bytes, b->latlong->bytes) << spec;
    }
}

TEST(Environment, MisspeltNamesAndKeysAreAnsweredWithTheRightOnes) {
    EXPECT_EQ(refusal("studoi").code, base::ErrorCode::usage);
    EXPECT_NE(base::to_line(refusal("studoi")).find("did you mean studio"), std::string::npos);
    EXPECT_NE(base::to_line(refusal("sky:turbidty=3")).find("did you mean turbidity"),
              std::string::npos);
    EXPECT_NE(base::to_line(refusal("sky:turbidity=30")).find("1.9 to 10"), std::string::npos);
    EXPECT_EQ(refusal("studio:turbidity=3").code, base::ErrorCode::usage);
    EXPECT_EQ(refusal("/nonexistent/room.hdr").code, base::ErrorCode::input_invalid);
}

/// A temporary .hdr of one value, gone with the object.
class HdrFile {
public:
    HdrFile(math::Extent size, float value) {
        image::Image picture(size, 3, image::Sample::f32);
        for (float& x : picture.as<float>()) x = value;
        const auto bytes = image::encode(picture, {.format = tables::ImageFormat::hdr});
        EXPECT_TRUE(bytes);
        if (bytes) {
            EXPECT_TRUE(base::write_file_atomically(path_, *bytes));
        }
    }
    ~HdrFile() { std::filesystem::remove(path_); }
    HdrFile(const HdrFile&) = delete;
    HdrFile& operator=(const HdrFile&) = delete;
    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                  ("facet_environment_" + std::to_string(::getpid()) + ".hdr");
};

TEST(Environment, FileIsReadAsItIsWithoutAWarningWhereItIsTwiceAsWideAsHigh) {
    const HdrFile file({8, 4}, 2.0F);
    const Loaded loaded = load(file.path());
    EXPECT_TRUE(loaded.warnings.empty());
    EXPECT_EQ(pixel(loaded.environment, 3, 2), Vec3(2.0F));
}

TEST(Environment, FileOfAnotherShapeOrAllBlackIsReadWithAWarning) {
    const HdrFile square({8, 8}, 1.0F);
    ASSERT_EQ(load(square.path()).warnings.size(), 1U);
    EXPECT_EQ(load(square.path()).warnings[0].found, "8x8");
    const HdrFile black({8, 4}, 0.0F);
    ASSERT_EQ(load(black.path()).warnings.size(), 1U);
    EXPECT_NE(load(black.path()).warnings[0].what.find("black"), std::string::npos);
}

}  // namespace
}  // namespace facet::scene
