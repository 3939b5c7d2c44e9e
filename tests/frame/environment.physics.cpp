// The bake of image-based light: orientation, exact cases, lobes against brute force, irradiance.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "frame/environment/bake.h"
#include "frame/environment/irradiance.h"
#include "image/read.h"
#include "math/cube_map.h"
#include "math/half.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <functional>

namespace facet::frame {
namespace {

using math::Vec3;
constexpr double pi = 3.14159265358979323846;

/// Radiance by direction, sampled at pixel centres: middle column -z, to the right +x (contract).
image::Image picture(std::uint32_t height, const std::function<Vec3(const Vec3&)>& radiance) {
    image::Image out({2 * height, height}, 3, image::Sample::f32);
    auto pixels = out.as<float>();
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < 2 * height; ++x) {
            const double theta = (y + 0.5) / height * pi;
            const double phi = ((x + 0.5) / (2.0 * height) - 0.5) * 2.0 * pi;
            const Vec3 d(std::sin(phi) * std::sin(theta), std::cos(theta),
                         -std::cos(phi) * std::sin(theta));
            const Vec3 value = radiance(d);
            for (int c = 0; c < 3; ++c)
                pixels[(std::size_t{y} * 2 * height + x) * 3 + static_cast<std::size_t>(c)] =
                    value[c];
        }
    return out;
}

BakedEnvironment bake(const image::Image& latlong, float rotation_deg = 0.0F,
                      float intensity = 1.0F) {
    base::ThreadPool pool(2);
    base::Warnings warnings;
    return bake_environment(latlong, rotation_deg, intensity, pool, warnings);
}

Vec3 texel(const BakedEnvironment& baked, std::size_t level, std::size_t face, std::size_t row,
           std::size_t column) {
    const std::size_t side = baked.face_px >> level;
    const std::uint16_t* p =
        baked.radiance[level].data() + ((face * side + row) * side + column) * 4;
    return {math::float_from_half(p[0]), math::float_from_half(p[1]), math::float_from_half(p[2])};
}
Vec3 texel_direction(const BakedEnvironment& baked, std::size_t level, std::size_t face,
                     std::size_t row, std::size_t column) {
    const auto side = static_cast<float>(baked.face_px >> level);
    return math::normalize(math::direction_from(math::CubePoint{
        static_cast<std::uint32_t>(face), (static_cast<float>(column) + 0.5F) / side * 2.0F - 1.0F,
        (static_cast<float>(row) + 0.5F) / side * 2.0F - 1.0F}));
}
/// What a level-0 look-up in `direction` returns, nearest texel.
Vec3 reflected(const BakedEnvironment& baked, const Vec3& direction) {
    const math::CubePoint p = math::cube_point_from(direction);
    const auto index = [&](float x) {
        return static_cast<std::size_t>((x + 1.0F) * 0.5F * static_cast<float>(baked.face_px) *
                                        0.9999F);
    };
    return texel(baked, 0, p.face, index(p.t), index(p.s));
}

/// Visits some texels of each level's every face.
void for_some_texels(
    const BakedEnvironment& baked,
    const std::function<void(std::size_t level, const Vec3& n, const Vec3& value)>& visit) {
    for (std::size_t level = 0; level < baked.radiance.size(); ++level) {
        const std::size_t side = baked.face_px >> level;
        for (std::size_t k = 0; k < 24; ++k) {
            const std::size_t row = (k * 37 + 11) % side;
            const std::size_t column = (k * 53 + 5) % side;
            visit(level, texel_direction(baked, level, k % 6, row, column),
                  texel(baked, level, k % 6, row, column));
        }
    }
}

/// D(h) (n.l), n = v = l (Walter et al. 2007, Eq. 33, without its constant).
double lobe(double cosine, double alpha) {
    if (cosine <= 0.0) return 0.0;
    const double q = 0.5 * (1.0 + cosine) * (alpha * alpha - 1.0) + 1.0;
    return cosine / (q * q);
}

/// The prefiltered value by summing over every pixel of the picture.
Vec3 brute_force(const image::Image& latlong, const Vec3& n, double alpha) {
    const auto pixels = latlong.as<float>();
    double sum[3] = {};
    double weights = 0.0;
    for (std::uint32_t y = 0; y < latlong.size.height; ++y) {
        const double theta = (y + 0.5) / latlong.size.height * pi;
        for (std::uint32_t x = 0; x < latlong.size.width; ++x) {
            const double phi = ((x + 0.5) / latlong.size.width - 0.5) * 2.0 * pi;
            const double cosine = static_cast<double>(n.x) * std::sin(phi) * std::sin(theta) +
                                  static_cast<double>(n.y) * std::cos(theta) -
                                  static_cast<double>(n.z) * std::cos(phi) * std::sin(theta);
            const double w = lobe(cosine, alpha) * std::sin(theta);
            weights += w;
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += w * static_cast<double>(
                                  pixels[(std::size_t{y} * latlong.size.width + x) * 3 + c]);
        }
    }
    return {static_cast<float>(sum[0] / weights), static_cast<float>(sum[1] / weights),
            static_cast<float>(sum[2] / weights)};
}

double alpha_of(const BakedEnvironment& baked, std::size_t level) {
    const double roughness =
        static_cast<double>(level) / static_cast<double>(baked.radiance.size() - 1);
    return roughness * roughness;
}

TEST(EnvironmentBake, ConstantEnvironmentIsThatConstantInEveryTexelOfEveryLevel) {
    const BakedEnvironment baked = bake(picture(64, [](const Vec3&) { return Vec3(1.0F); }));
    for (const auto& level : baked.radiance)
        for (std::size_t i = 0; i < level.size(); ++i) ASSERT_EQ(level[i], 0x3C00) << i;
}

TEST(EnvironmentBake, ConstantEnvironmentHasTheSameIrradianceOverPiInEveryDirection) {
    const BakedEnvironment baked = bake(picture(64, [](const Vec3&) { return Vec3(2.5F); }));
    EXPECT_NEAR(baked.irradiance_sh[0].x, 2.5F, 1e-5F);
    for (std::size_t i = 1; i < 9; ++i) EXPECT_NEAR(baked.irradiance_sh[i].x, 0.0F, 1e-5F) << i;
}

TEST(EnvironmentBake, FaceIsTwoHundredFiftySixForAOneKiloPixelPictureWithSixLevelsDownToEight) {
    const BakedEnvironment baked = bake(image::Image({1024, 512}, 3, image::Sample::f32));
    EXPECT_EQ(baked.face_px, 256U);
    ASSERT_EQ(baked.radiance.size(), 6U);
    EXPECT_EQ(baked.radiance.back().size(), 6U * 8U * 8U * 4U);
}

// Colour = position on the unit sphere: whatever face, row or column is mixed up changes it.
TEST(EnvironmentBake, EveryTexelOfLevelZeroHasTheColourOfItsDirectionInThePicture) {
    const BakedEnvironment baked =
        bake(picture(256, [](const Vec3& d) { return 1.0F + 0.5F * d; }));
    for (std::size_t face = 0; face < 6; ++face)
        for (std::size_t row = 0; row < baked.face_px; ++row)
            for (std::size_t column = 0; column < baked.face_px; ++column) {
                const Vec3 expected = 1.0F + 0.5F * texel_direction(baked, 0, face, row, column);
                const Vec3 found = texel(baked, 0, face, row, column);
                // Half floats below 2 have a step of 2^-10; averaging over a texel does less.
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(found[c], expected[c], 1e-3F)
                        << face << ' ' << row << ' ' << column << ' ' << c;
            }
}

TEST(EnvironmentBake, MiddleColumnIsMinusZAndColumnsToItsRightTurnTowardsPlusX) {
    image::Image latlong({256, 128}, 3, image::Sample::f32);
    auto pixels = latlong.as<float>();
    for (std::uint32_t y = 56; y < 72; ++y)
        for (std::uint32_t x = 120; x < 136; ++x) {
            pixels[(y * 256 + x) * 3] = 1.0F;           // red at the middle
            pixels[(y * 256 + x + 64) * 3 + 1] = 1.0F;  // green a quarter to its right
        }
    for (std::uint32_t x = 0; x < 256; ++x) pixels[x * 3 + 2] = 1.0F;  // blue at the top
    const BakedEnvironment baked = bake(latlong);
    EXPECT_NEAR(reflected(baked, {0.01F, 0.01F, -1.0F}).x, 1.0F, 1e-3F);
    EXPECT_NEAR(reflected(baked, {1.0F, 0.01F, 0.01F}).y, 1.0F, 1e-3F);
    EXPECT_GT(reflected(baked, {0.001F, 1.0F, 0.001F}).z, 0.5F);
    EXPECT_EQ(reflected(baked, {0.0F, -1.0F, 0.0F}).z, 0.0F);
}

TEST(EnvironmentBake, RotationTurnsTheEnvironmentCounterClockwiseSeenFromAbove) {
    const auto lit = [](const Vec3& d) { return d.z < -0.95F ? Vec3(1.0F) : Vec3(0.0F); };  // at -z
    const image::Image latlong = picture(128, lit);
    // Seen from above with +x right and -z up, a quarter turn takes up to the left: -x.
    EXPECT_NEAR(reflected(bake(latlong, 90.0F), {-1.0F, 0.0F, 0.0F}).x, 1.0F, 1e-3F);
    EXPECT_NEAR(reflected(bake(latlong, -90.0F), {1.0F, 0.0F, 0.0F}).x, 1.0F, 1e-3F);
    EXPECT_NEAR(reflected(bake(latlong, 540.0F), {0.0F, 0.0F, 1.0F}).x, 1.0F, 1e-3F);
    const Vec3 towards =
        evaluate_irradiance(bake(latlong, 90.0F).irradiance_sh, {-1.0F, 0.0F, 0.0F});
    const Vec3 unturned = evaluate_irradiance(bake(latlong).irradiance_sh, {0.0F, 0.0F, -1.0F});
    EXPECT_NEAR(towards.x, unturned.x, 1e-5F);
}

TEST(EnvironmentBake, IntensityMultipliesReflectionsAndIrradiance) {
    const image::Image latlong = picture(64, [](const Vec3& d) { return Vec3(1.0F + 0.5F * d.y); });
    const BakedEnvironment one = bake(latlong);
    const BakedEnvironment four = bake(latlong, 0.0F, 4.0F);
    EXPECT_NEAR(texel(four, 1, 2, 8, 8).x, 4.0F * texel(one, 1, 2, 8, 8).x, 4e-3F);
    EXPECT_NEAR(four.irradiance_sh[1].x, 4.0F * one.irradiance_sh[1].x, 1e-5F);
}

// A linear gradient seen through any lobe is the gradient times the lobe's mean cosine: known in
// closed form.
TEST(EnvironmentBake, GradientThroughEveryLobeIsWithinOnePercentOfItsExactValue) {
    const BakedEnvironment baked =
        bake(picture(256, [](const Vec3& d) { return 1.0F + 0.5F * d; }));
    for_some_texels(baked, [&](std::size_t level, const Vec3& n, const Vec3& value) {
        double cosine = level == 0 ? 1.0 : 0.0;
        double weights = level == 0 ? 1.0 : 0.0;
        for (int i = 0; level > 0 && i < 2000; ++i) {
            const double theta = (i + 0.5) / 2000.0 * pi / 2.0;
            const double w = lobe(std::cos(theta), alpha_of(baked, level)) * std::sin(theta);
            cosine += w * std::cos(theta);
            weights += w;
        }
        const auto mean = static_cast<float>(cosine / weights);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(value[c], 1.0F + 0.5F * mean * n[c], 0.01F)
                << "level " << level << " channel " << c;
    });
}

TEST(EnvironmentBake, SoftBoxesThroughEveryLobeAreWithinAFewPercentOfBruteForce) {
    const auto room = [](const Vec3& d) {
        const float box = std::fabs(d.x) < 0.4F && d.y > 0.6F ? 20.0F : 0.0F;
        return Vec3(0.3F + box, 0.5F + 0.3F * d.y, d.z > 0.9F ? 8.0F : 0.2F);
    };
    const image::Image latlong = picture(128, room);
    const BakedEnvironment baked = bake(latlong);
    double error = 0.0;
    double most = 0.0;
    int count = 0;
    for_some_texels(baked, [&](std::size_t level, const Vec3& n, const Vec3& value) {
        if (level == 0) return;
        const Vec3 expected = brute_force(latlong, n, alpha_of(baked, level));
        for (int c = 0; c < 3; ++c) {
            const double e = std::fabs(static_cast<double>(value[c] / expected[c] - 1.0F));
            error += e;
            most = std::max(most, e);
            ++count;
        }
    });
    // The mixture of octaves is within 4 % of the lobe; edges of boxes inside a texel of a mip add
    // to that.
    EXPECT_LT(error / count, 0.03);
    EXPECT_LT(most, 0.3);
}

// One pixel holds nearly all the light. Around it the reflection must fall evenly: no dots, no
// rings.
TEST(EnvironmentBake, SunOfOnePixelGivesOneSmoothHighlightOnEveryLevel) {
    image::Image latlong({1024, 512}, 3, image::Sample::f32);
    auto pixels = latlong.as<float>();
    const std::size_t sun = (std::size_t{180} * 1024 + 640) * 3;
    for (std::size_t c = 0; c < 3; ++c) pixels[sun + c] = 6e4F;
    const double theta = 180.5 / 512 * pi;
    const double phi = (640.5 / 1024 - 0.5) * 2.0 * pi;
    const Vec3 to_sun(std::sin(phi) * std::sin(theta), std::cos(theta),
                      -std::cos(phi) * std::sin(theta));
    const BakedEnvironment baked = bake(latlong);
    for (std::size_t level = 1; level < 4; ++level) {
        const double alpha = alpha_of(baked, level);
        const std::size_t side = baked.face_px >> level;
        double worst = 1.0;
        for (std::size_t i = 0; i < 6 * side * side; ++i) {
            const std::size_t face = i / (side * side);
            const std::size_t row = i / side % side;
            const Vec3 n = texel_direction(baked, level, face, row, i % side);
            const double shape =
                lobe(static_cast<double>(math::dot(n, to_sun)), alpha) / lobe(1.0, alpha);
            if (shape < 0.01) continue;
            // Normalised by the lobe's integral, which brute force would divide by.
            const double value = static_cast<double>(texel(baked, level, face, row, i % side).x);
            double integral = 0.0;
            for (int k = 0; k < 500; ++k) {
                const double a = (k + 0.5) / 500.0 * pi / 2.0;
                integral +=
                    lobe(std::cos(a), alpha) / lobe(1.0, alpha) * std::sin(a) * pi * pi / 500.0;
            }
            const double omega = 2.0 * pi / 1024 * pi / 512 * std::sin(theta);
            const double ratio = value / (6e4 * omega * shape / integral);
            worst = std::max({worst, ratio, 1.0 / ratio});
        }
        EXPECT_LT(worst, 1.5) << "level " << level;  // random sampling: 5 to 40
    }
}

TEST(EnvironmentBake, BytesDoNotDependOnTheNumberOfThreads) {
    const image::Image latlong = picture(
        128, [](const Vec3& d) { return Vec3(std::exp(3.0F * d.x), 1.0F + d.y * d.z, d.y * d.y); });
    base::Warnings warnings;
    base::ThreadPool one(1);
    base::ThreadPool five(5);
    const BakedEnvironment a = bake_environment(latlong, 33.0F, 1.5F, one, warnings);
    const BakedEnvironment b = bake_environment(latlong, 33.0F, 1.5F, five, warnings);
    EXPECT_EQ(a.radiance, b.radiance);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(a.irradiance_sh[i], b.irradiance_sh[i]);
}

TEST(EnvironmentBake, RadianceAboveTheLargestHalfIsCutWithOneWarning) {
    base::ThreadPool pool(1);
    base::Warnings warnings;
    const auto baked = bake_environment(picture(64, [](const Vec3&) { return Vec3(1e6F); }), 0.0F,
                                        1.0F, pool, warnings);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(texel(baked, 0, 0, 0, 0).x, math::half_max);
    EXPECT_NEAR(baked.irradiance_sh[0].x, 1e6F, 10.0F);
}

TEST(EnvironmentBake, PicturesOfOnePixelAndOddSizesAreBaked) {
    for (const math::Extent size : {math::Extent{1, 1}, {3, 1}, {1, 7}, {101, 37}}) {
        image::Image latlong(size, 3, image::Sample::f32);
        for (float& x : latlong.as<float>()) x = 0.5F;
        const BakedEnvironment baked = bake(latlong, 10.0F);
        EXPECT_EQ(texel(baked, 0, 2, 3, 3).x, 0.5F) << size.width << 'x' << size.height;
        EXPECT_NEAR(baked.irradiance_sh[0].x, 0.5F, 1e-5F);
    }
}

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

TEST(EnvironmentBake, PhotographedStudioIsWithinAFewPercentOfBruteForceWhereItIsPresent) {
    const std::string path = std::string(FACET_SOURCE_DIR) + "/../shared/assets/hdri/studio_1k.hdr";
    const base::Limits limits;
    const auto file = base::read_file(path, limits.file_bytes);
    if (!file) GTEST_SKIP() << "no picture at " << path;
    base::Warnings warnings;
    const auto latlong = image::decode(*file, limits, warnings);
    ASSERT_TRUE(latlong) << base::to_line(latlong.error());
    const BakedEnvironment baked = bake(*latlong);
    double error = 0.0;
    int count = 0;
    for (std::size_t level = 1; level < baked.radiance.size(); ++level)
        for (std::size_t face = 0; face < 6; ++face) {
            const std::size_t side = baked.face_px >> level;
            const Vec3 n = texel_direction(baked, level, face, side / 3, side / 4);
            const Vec3 expected = brute_force(*latlong, n, alpha_of(baked, level));
            const Vec3 found = texel(baked, level, face, side / 3, side / 4);
            error += std::fabs(static_cast<double>(found.y / expected.y - 1.0F));
            ++count;
        }
    EXPECT_LT(error / count, 0.06);
}

}  // namespace
}  // namespace facet::frame
