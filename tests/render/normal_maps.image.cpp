// Bumps that are finer than pixels: highlights on them against those of bumps that are seen.
// SPDX-License-Identifier: MIT
#include "support/frame_harness.h"
#include "support/trace_harness.h"

#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace facet::test {
namespace {

using tables::TextureSlot;

constexpr std::uint32_t map_texels = 256;
constexpr float texels_per_m = 128.0F;
/// A pixel of the picture from nearby is this wide; from afar, 4 and 16 times.
constexpr float pixel_m = 2.0F / 128.0F;

/// Slopes of a bumpy surface to a normal map.
using Slopes = std::vector<math::Vec2>;

std::shared_ptr<const image::Image> map_of(const Slopes& slopes, std::uint8_t alpha = 255) {
    auto map =
        std::make_shared<image::Image>(math::Extent{map_texels, map_texels}, 4, image::Sample::u8);
    std::uint8_t* to = map->as<std::uint8_t>().data();
    for (const math::Vec2& slope : slopes) {
        const math::Vec3 n = math::normalize(math::Vec3(-slope, 1.0F));
        for (int c = 0; c < 3; ++c)
            *to++ = static_cast<std::uint8_t>(std::lround((n[c] * 0.5F + 0.5F) * 255.0F));
        *to++ = alpha;
    }
    return map;
}

/// Waves of 6 to 16 texels, all ways; `deviation` of slopes along an axis.
Slopes waves(float deviation) {
    std::mt19937 random(3);
    Slopes out(std::size_t{map_texels} * map_texels, math::Vec2(0.0F));
    constexpr int count = 48;
    const float each = deviation * 2.0F / std::sqrt(static_cast<float>(count));
    for (int i = 0; i < count; ++i) {
        math::Vec2 k(0.0F);
        while (math::length(k) < 16.0F || math::length(k) > 42.0F)
            k = {static_cast<float>(random() % 85) - 42.0F,
                 static_cast<float>(random() % 85) - 42.0F};
        const float phase = static_cast<float>(random() % 1000) * 0.00628F;
        for (std::uint32_t y = 0; y < map_texels; ++y)
            for (std::uint32_t x = 0; x < map_texels; ++x)
                out[y * map_texels + x] +=
                    math::normalize(k) * (each * std::sin(2.0F * math::pi / map_texels *
                                                              (k.x * static_cast<float>(x) +
                                                               k.y * static_cast<float>(y)) +
                                                          phase));
    }
    return out;
}

/// A slope of its own for every texel, none steeper than 3 deviations.
Slopes grains(float deviation) {
    std::mt19937 random(5);
    const auto normal = [&] {  // near enough: 12 even numbers
        float sum = -6.0F;
        for (int i = 0; i < 12; ++i) sum += static_cast<float>(random() % 65536) / 65536.0F;
        return std::clamp(sum, -3.0F, 3.0F);
    };
    Slopes out(std::size_t{map_texels} * map_texels);
    for (math::Vec2& slope : out) slope = {deviation * normal(), deviation * normal()};
    return out;
}

/// A wide plane of the map, below a lamp a metre over its middle.
scene::Scene bumpy_plane(const scene::Material& material, TextureSlot slot,
                         std::shared_ptr<const image::Image> map) {
    constexpr float side_m = 40.0F;
    scene::Mesh mesh = quad(side_m);
    mesh.tangents.assign(4, math::Vec4(1.0F, 0.0F, 0.0F, 1.0F));
    for (math::Vec2& uv : mesh.uv0) uv *= side_m * texels_per_m / map_texels;
    scene::Scene scene = scene_of(std::move(mesh), material);
    scene.images.push_back({"bumps", std::move(map)});
    scene.materials[0].textures[static_cast<std::size_t>(slot)] = scene::Texture{};
    scene.lights = {{.kind = tables::LightKind::point,
                     .intensity = 10.0F,
                     .position_m = math::Vec3(0.0F, 0.0F, 1.0F)}};
    return scene;
}

scene::Scene bumpy_metal(std::shared_ptr<const image::Image> map) {
    return bumpy_plane(material(math::Vec3(0.9F), 1.0F, 0.1F), TextureSlot::normal_texture,
                       std::move(map));
}

/// From above; a pixel is `times` as wide as from nearby.
constexpr std::uint32_t picture_px = 128;
scene::Camera camera_from(float times) {
    return camera_on_z(4.0F, pixel_m * times * 0.5F * static_cast<float>(picture_px));
}

/// How light falls off around the lamp's mirror image.
struct Highlight {
    double middle_nit = 0.0;     ///< mean of the square metre below the lamp
    double half_radius_m = 0.0;  ///< half of the light within a metre is within this
    std::vector<double> rings;   ///< mean radiance, by steps of an eighth of a metre
};
Highlight highlight(const image::Image& radiance, float times) {
    Highlight out;
    const auto values = radiance.as<float>();
    const double width_m = static_cast<double>(pixel_m * times) * picture_px;
    const double step_m = width_m / radiance.size.width;
    std::vector<std::pair<double, double>> by_radius;
    std::vector<double> counts(8, 0.0);
    out.rings.assign(8, 0.0);
    double middle = 0.0;
    for (std::uint32_t y = 0; y < radiance.size.height; ++y)
        for (std::uint32_t x = 0; x < radiance.size.width; ++x) {
            const double at_x = (x + 0.5) * step_m - width_m / 2.0;
            const double at_y = (y + 0.5) * step_m - width_m / 2.0;
            const double r = std::hypot(at_x, at_y);
            const auto nit =
                static_cast<double>(values[(std::size_t{y} * radiance.size.width + x) * 4]);
            if (std::fabs(at_x) < 0.5 && std::fabs(at_y) < 0.5) {
                out.middle_nit += nit;
                middle += 1.0;
            }
            if (r >= 1.0) continue;
            by_radius.emplace_back(r, nit);
            out.rings[static_cast<std::size_t>(r * 8.0)] += nit;
            counts[static_cast<std::size_t>(r * 8.0)] += 1.0;
        }
    out.middle_nit /= middle;
    std::ranges::sort(by_radius);
    double all = 0.0;
    for (const auto& [r, nit] : by_radius) all += nit;
    double part = 0.0;
    for (const auto& [r, nit] : by_radius) {
        part += nit;
        out.half_radius_m = r;
        if (part >= all / 2.0) break;
    }
    for (std::size_t i = 0; i < 8; ++i) out.rings[i] /= std::max(counts[i], 1.0);
    return out;
}

/// Mean difference of the rings, as a share of the brightest.
double rings_apart(const Highlight& a, const Highlight& truth) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 8; ++i) sum += std::fabs(a.rings[i] - truth.rings[i]);
    return sum / 8.0 / *std::ranges::max_element(truth.rings);
}

struct Distance {
    float times = 1.0F;
    std::uint32_t finer = 1;  ///< pixels along each side of one
};
Highlight drawn(Harness& harness, const scene::Scene& scene, const Distance& from) {
    const std::uint32_t side = picture_px * from.finer;
    const auto picture =
        harness.draw({.scene = scene, .camera = camera_from(from.times), .size = {side, side}});
    if (picture) return highlight(picture->radiance, from.times);
    ADD_FAILURE() << base::to_line(picture.error());
    return {};
}

Highlight traced_from(const scene::Scene& scene, float times) {
    TraceShot shot{.scene = scene, .camera = camera_from(times)};
    shot.settings.picture = shot.settings.size = {picture_px, picture_px};
    shot.settings.samples = 4;  // a ray stands for half a pixel
    return highlight(traced(shot).radiance, times);
}

/// A lobe of GGX has longer tails than bumps of such maps: where it is as bright in its middle a
/// fifth of its light is further out than theirs (numerical integration, slopes of a normal
/// distribution), and the lamp is nearer to the middle. The mean normal alone, a mirror, is off by
/// 4 to 40 times here.
constexpr double wide_tails = 0.3;

/// Of the metre around the middle, where pixels are fine enough to tell.
void expect_like(const Highlight& found, const Highlight& truth, bool has_rings,
                 const std::string& what) {
    EXPECT_NEAR(found.middle_nit / truth.middle_nit, 1.0, wide_tails) << what;
    if (!has_rings) return;
    EXPECT_NEAR(found.half_radius_m / truth.half_radius_m, 1.0, wide_tails) << what;
    EXPECT_LT(rings_apart(found, truth), 0.15) << what;
}

struct Bumps {
    const char* name;
    Slopes slopes;
};
std::vector<Bumps> every_bumps() {
    return {{"low waves", waves(0.1F)}, {"waves", waves(0.3F)}, {"grains", grains(0.3F)}};
}

TEST(NormalMaps, HighlightsOnBumpsFinerThanPixelsAreAsBrightAndWideAsOnThoseThatAreSeen) {
    Harness harness;
    for (const Bumps& bumps : every_bumps()) {
        const scene::Scene scene = bumpy_metal(map_of(bumps.slopes));
        const Highlight truth = drawn(harness, scene, {1.0F, 4});  // two pixels a texel
        for (const float times : {1.0F, 4.0F, 16.0F})              // 2, 8, 32 texels a pixel
            expect_like(drawn(harness, scene, {times}), truth, times < 16.0F,
                        fmt::format("{} from {} times as far", bumps.name, times));
        for (const float times : {4.0F, 16.0F})
            expect_like(traced_from(scene, times), truth, times < 16.0F,
                        fmt::format("{} traced from {} times as far", bumps.name, times));
        // What this is held against: the mean normal is that of a plane without bumps.
        scene::Scene flat = scene;
        flat.materials[0].textures = {};
        EXPECT_LT(drawn(harness, flat, {16.0F}).middle_nit, truth.middle_nit / 4.0) << bumps.name;
    }
}

TEST(NormalMaps, ALacquerIsAsRoughAsItsOwnMapMakesIt) {
    Harness harness;
    scene::Material lacquered = material(math::Vec3(0.0F), 0.0F, 0.8F);
    lacquered.values.specular = 0.0F;
    lacquered.values.clearcoat = 1.0F;
    lacquered.values.clearcoat_roughness = 0.1F;
    const scene::Scene scene =
        bumpy_plane(lacquered, TextureSlot::clearcoat_normal_texture, map_of(waves(0.2F)));
    const Highlight truth = drawn(harness, scene, {1.0F, 4});
    ASSERT_GT(truth.middle_nit, 0.0);
    expect_like(drawn(harness, scene, {4.0F}), truth, true, "drawn");
    expect_like(traced_from(scene, 4.0F), truth, true, "traced");
}

/// Both renderers' AOV `roughness` in the middle of the picture.
std::array<float, 2> roughness_of(Harness& harness, const scene::Scene& scene, float times) {
    const std::vector<tables::Aov> aovs{tables::Aov::roughness};
    const auto raster = harness.draw({.scene = scene, .camera = camera_from(times), .aovs = aovs});
    TraceShot shot{.scene = scene, .camera = camera_from(times)};
    base::ThreadPool pool;
    const scene::Environment environment{"test", shot.latlong};
    const auto tracer = trace::Tracer::create(
        {.scene = scene, .environment = environment, .camera = shot.camera, .brdf = {}}, {}, pool);
    if (!raster || !tracer) {
        ADD_FAILURE() << "nothing drawn";
        return {};
    }
    const auto middle = [](const image::Image& aov) {
        return aov.as<float>()[(std::size_t{32} * aov.size.width + 32) * aov.channels];
    };
    return {middle(raster->aovs[0].image),
            middle(tracer->aovs(shot.settings, aovs, pool)[0].image)};
}

/// Of slopes that are linear between texels, both axes: along a side the mean of their squares is
/// that of a / 6 + 2 b / 3 + c / 6 times b.
double variance_between_texels(const Slopes& slopes) {
    double sum = 0.0;
    for (std::uint32_t i = 0; i < slopes.size(); ++i)
        for (std::uint32_t k = 0; k < 9; ++k) {
            const std::uint32_t x = (i % map_texels + k % 3 + map_texels - 1) % map_texels;
            const std::uint32_t y = (i / map_texels + k / 3 + map_texels - 1) % map_texels;
            const double share =
                (k % 3 == 1 ? 2.0 / 3.0 : 1.0 / 6.0) * (k / 3 == 1 ? 2.0 / 3.0 : 1.0 / 6.0);
            sum += share * static_cast<double>(math::dot(slopes[i], slopes[y * map_texels + x]));
        }
    return sum / static_cast<double>(slopes.size());
}

// The G-buffer holds roughness in 8 bits; the picture of 64 pixels has twice as many texels each.
TEST(NormalMaps, RoughnessThatIsShownHasTheBumpsThatAreNot) {
    Harness harness;
    const Slopes slopes = waves(0.2F);
    const double variance = variance_between_texels(slopes);
    const scene::Scene scene = bumpy_metal(map_of(slopes));
    const auto expected = static_cast<float>(std::pow(1e-4 + variance, 0.25));
    for (const float found : roughness_of(harness, scene, 16.0F))
        EXPECT_NEAR(found, expected, 0.03F * expected);
    scene::Scene half = scene;  // slopes count as they are scaled, down or up
    half.materials[0].values.normal_scale = -0.5F;
    for (const float found : roughness_of(harness, half, 16.0F))
        EXPECT_NEAR(found, std::pow(1e-4F + static_cast<float>(variance) / 4.0F, 0.25F),
                    0.03F * expected);
    for (const float found : roughness_of(harness, scene, 0.1F))
        EXPECT_NEAR(found, 0.1F, 0.5F / 255.0F + 1e-6F) << "every texel is seen";
}

TEST(NormalMaps, AnImageThatIsMoreThanANormalMapKeepsItsAlpha) {
    Harness harness;
    scene::Scene scene = bumpy_plane(material(math::Vec3(0.0F), 0.0F, 0.3F),
                                     TextureSlot::normal_texture, map_of(waves(0.1F), 128));
    const auto plain = harness.draw({.scene = scene, .camera = camera_from(0.1F)});
    scene.materials[0].textures[static_cast<std::size_t>(TextureSlot::specular_texture)] =
        scene::Texture{};
    const auto halved = harness.draw({.scene = scene, .camera = camera_from(0.1F)});
    ASSERT_TRUE(plain && halved);
    // Reflection at right angles is half as strong, in 16 bits of F0's share.
    for (const std::uint32_t x : {20U, 32U, 44U})
        EXPECT_NEAR(halved->at(x, 32).x / plain->at(x, 32).x, 128.0F / 255.0F, 0.02F);
    for (const float found : roughness_of(harness, scene, 0.1F))
        EXPECT_NEAR(found, 0.3F, 0.5F / 255.0F + 1e-6F);
}

}  // namespace
}  // namespace facet::test
