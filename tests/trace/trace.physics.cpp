// Whole pictures against what is known on paper: furnaces, convergence, masks, and the same bytes
// for any threads. SPDX-License-Identifier: MIT
#include "trace/trace.h"

#include "support/trace_harness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace facet::test {
namespace {

using math::Vec3;
using math::Vec4;

TEST(Reference, AWhiteSphereVanishesInAFurnace) {
    for (const float metallic : {0.0F, 0.5F, 1.0F})
        for (const float roughness : {0.0F, 0.1F, 0.4F, 1.0F}) {
            TraceShot shot{.scene = scene_of(sphere(96), material(Vec3(1.0F), metallic, roughness)),
                           .latlong = constant_environment(Vec3(1.0F))};
            shot.settings.samples = 64;
            const auto out = traced(shot);
            EXPECT_EQ(out.not_finite, 0U);
            const Vec4 sum = mean(out.radiance);
            // Light that a facet sends below the surface is lost, and so is what the tessellation
            // hides of itself; the standard error of 4096 x 64 paths is below 1e-3.
            EXPECT_NEAR(sum.x / sum.w, 1.0F, 5e-3F)
                << "metallic " << metallic << " roughness " << roughness;
        }
}

/// A box seen from inside, its walls turned inwards.
scene::Mesh inside_of_box() {
    scene::Mesh mesh{.name = "box", .material = {}};
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0F, 1.0F}) {
            const auto first = static_cast<std::uint32_t>(mesh.positions_m.size());
            for (int corner = 0; corner < 4; ++corner) {
                Vec3 p(0.0F);
                p[axis] = side;
                p[(axis + 1) % 3] = (corner & 1) != 0 ? 1.0F : -1.0F;
                p[(axis + 2) % 3] = (corner & 2) != 0 ? 1.0F : -1.0F;
                Vec3 n(0.0F);
                n[axis] = -side;
                mesh.positions_m.push_back(p);
                mesh.normals.push_back(n);
                mesh.bounds_m.add(p);
            }
            if (side < 0.0F)
                mesh.indices.insert(mesh.indices.end(),
                                    {first, first + 1, first + 2, first + 2, first + 1, first + 3});
            else
                mesh.indices.insert(mesh.indices.end(),
                                    {first, first + 2, first + 1, first + 1, first + 2, first + 3});
        }
    return mesh;
}

// A white wall of the default model returns all light from everywhere, so each bounce in a closed
// box whose walls emit 1 adds exactly 1.
TEST(Reference, EveryBounceInAWhiteFurnaceBoxAddsWhatTheWallsEmit) {
    for (const std::uint32_t bounces : {0U, 1U, 5U}) {
        scene::Material wall = material(Vec3(1.0F), 0.0F, 0.5F);
        wall.values.emissive = Vec3(1.0F);
        TraceShot shot{.scene = scene_of(inside_of_box(), wall)};
        shot.camera.world_from_view[3] = math::Vec4(0.1F, 0.2F, 0.3F, 1.0F);
        shot.camera.projection = scene::Projection::perspective;
        shot.camera.far_m = 0.0F;
        shot.settings.samples = 64;
        shot.settings.bounces = bounces;
        const Vec4 sum = mean(traced(shot).radiance);
        EXPECT_NEAR(sum.w, 1.0F, 1e-6F);
        EXPECT_NEAR(sum.x, 1.0F + static_cast<float>(bounces),
                    0.01F * (1.0F + static_cast<float>(bounces)));
    }
}

TEST(Reference, AMirrorShowsTheEnvironmentAsItIs) {
    auto halves = std::make_shared<image::Image>(math::Extent{256, 128}, 3, image::Sample::f32);
    const auto values = halves->as<float>();
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = i < values.size() / 2 ? 2.0F : 0.5F;
    TraceShot shot{.scene = scene_of(sphere(96), material(Vec3(1.0F), 1.0F, 0.0F)),
                   .latlong = halves};
    const auto out = traced(shot);
    EXPECT_NEAR(pixel(out.radiance, 32, 16).x, 2.0F, 1e-3F);
    EXPECT_NEAR(pixel(out.radiance, 32, 47).x, 0.5F, 1e-3F);
}

TraceShot lit_box() {
    scene::Material wall = material(Vec3(0.6F, 0.5F, 0.4F), 0.0F, 0.6F);
    TraceShot shot{.scene = scene_of(inside_of_box(), wall)};
    shot.scene.lights = {{.kind = tables::LightKind::rect,
                          .intensity = 5.0F,
                          .position_m = {0.0F, 0.9F, 0.0F},
                          .direction = {0.0F, -1.0F, 0.0F},
                          .width_m = 0.5F,
                          .height_m = 0.5F}};
    shot.camera.world_from_view[3] = math::Vec4(0.0F, 0.0F, 0.9F, 1.0F);
    shot.camera.projection = scene::Projection::perspective;
    shot.camera.far_m = 0.0F;
    shot.settings.picture = shot.settings.size = {32, 32};
    return shot;
}

double rmse(const image::Image& a, const image::Image& b) {
    double squares = 0.0;
    const auto va = a.as<float>();
    const auto vb = b.as<float>();
    for (std::size_t i = 0; i < va.size(); ++i) {
        const double error = static_cast<double>(va[i]) - static_cast<double>(vb[i]);
        squares += error * error;
    }
    return std::sqrt(squares / static_cast<double>(va.size()));
}

TEST(Reference, ErrorOfAnInterreflectingBoxFallsAsOneOverTheRootOfItsSamplesOrFaster) {
    TraceShot shot = lit_box();
    shot.settings.samples = 4096;
    const image::Image truth = traced(shot).radiance;
    shot.settings.seed = 1;
    std::vector<double> errors;
    for (const std::uint32_t samples : {4U, 16U, 64U, 256U}) {
        shot.settings.samples = samples;
        errors.push_back(rmse(traced(shot).radiance, truth));
    }
    // Independent samples give -1/2; well spread ones do a little better. Four steps of a factor 4
    // tell the slope to 0.05 (1024 pixels; the truth itself errs by 1/4 of the last).
    const double slope = std::log(errors.back() / errors.front()) / std::log(64.0);
    EXPECT_LT(slope, -0.45);
    EXPECT_GT(slope, -0.75);
}

TEST(Reference, BytesAreTheSameForAnyNumberOfThreads) {
    TraceShot shot = lit_box();
    shot.settings.noise = 0.02;
    shot.settings.samples = 128;
    shot.threads = 1;
    const auto one = traced(shot);
    shot.threads = 5;
    const auto five = traced(shot);
    EXPECT_EQ(one.radiance.bytes, five.radiance.bytes);
    EXPECT_EQ(one.rays, five.rays);
}

TEST(Reference, ARegionIsThatPartOfThePicture) {
    TraceShot shot = lit_box();
    const auto whole = traced(shot).radiance;
    shot.settings.x = 7;
    shot.settings.y = 11;
    shot.settings.size = {9, 5};
    const auto part = traced(shot).radiance;
    for (std::uint32_t y = 0; y < 5; ++y)
        for (std::uint32_t x = 0; x < 9; ++x)
            EXPECT_EQ(pixel(part, x, y), pixel(whole, x + 7, y + 11)) << x << "," << y;
}

TEST(Reference, StopsAtTheNoiseAskedForAndIsNoWorseThanItSays) {
    TraceShot shot = lit_box();
    shot.settings.samples = 2048;
    const auto truth = traced(shot);
    shot.settings.seed = 3;
    shot.settings.noise = 0.01;
    const auto quick = traced(shot);
    EXPECT_LT(quick.samples, 1024.0);
    EXPECT_LE(quick.noise, 0.01);
    double squares = 0.0;
    const auto srgb = [](float x) {
        return x <= 0.0F ? 0.0 : std::pow(std::min(1.0, static_cast<double>(x)), 1 / 2.2);
    };
    const auto a = truth.radiance.as<float>();
    const auto b = quick.radiance.as<float>();
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += (srgb(a[i]) - srgb(b[i])) * (srgb(a[i]) - srgb(b[i]));
    // The estimate looks at luminance, this at each channel: up to sqrt(3) more for noise that is
    // one channel's.
    EXPECT_LE(std::sqrt(squares / static_cast<double>(a.size())), 0.02);
}

TEST(Reference, SamplesThatAreNotFiniteAreCountedAndLeftOut) {
    TraceShot shot = lit_box();
    shot.scene.materials[0].values.emissive_strength = INFINITY;
    shot.scene.materials[0].values.emissive = Vec3(1.0F);
    const auto out = traced(shot);
    EXPECT_EQ(out.not_finite, out.paths);
    for (const float value : out.radiance.as<float>()) EXPECT_TRUE(std::isfinite(value));
}

TEST(Reference, HolesOfAMaskShowWhatIsBehindAndLightPassesThem) {
    scene::Material gone = material(Vec3(1.0F), 0.0F, 1.0F);
    gone.alpha_mode = scene::AlphaMode::mask;
    gone.values.opacity = 0.2F;
    TraceShot shot{.scene = scene_of(quad(2.0F), material(Vec3(0.5F), 0.0F, 1.0F))};
    shot.scene.lights = {
        {.kind = tables::LightKind::directional, .intensity = 3.0F, .direction = {0, 0, -1}}};
    const Vec4 bare = mean(traced(shot).radiance);
    add(shot.scene, quad(2.0F), gone, glm::translate(math::Mat4(1.0F), Vec3(0, 0, 0.5F)));
    EXPECT_EQ(mean(traced(shot).radiance), bare);
}

// A lamp with a hole: what is drawn from it and what rays meet must be the same lamp.
TEST(Reference, HolesOfAMaskThatEmitsGiveNoLight) {
    TraceShot shot{.scene = scene_of(quad(2.0F), material(Vec3(0.5F), 0.0F, 1.0F))};
    scene::Material lamp = material(Vec3(0.0F), 0.0F, 1.0F);
    lamp.alpha_mode = scene::AlphaMode::mask;
    lamp.values.emissive = Vec3(1.0F);
    lamp.values.emissive_strength = 10.0F;
    lamp.double_sided = true;
    add(shot.scene, quad(0.5F), lamp, glm::translate(math::Mat4(1.0F), Vec3(0, 0, 0.5F)));
    EXPECT_GT(mean(traced(shot).radiance).x, 0.1F);
    shot.scene.materials[1].values.opacity = 0.1F;
    EXPECT_EQ(mean(traced(shot).radiance).x, 0.0F);
}

// Light falls through a sheet of opacity a, is reflected, and is seen through it again; the sheet
// itself is black.
TEST(Reference, ABlackSheetOfOpacityATakesItsShareOnTheWayInAndOut) {
    constexpr float opacity = 0.3F;
    TraceShot shot{.scene = scene_of(quad(2.0F), material(Vec3(0.5F), 0.0F, 1.0F))};
    shot.scene.lights = {
        {.kind = tables::LightKind::directional, .intensity = 3.0F, .direction = {0, 0, -1}}};
    shot.settings.samples = 256;
    const Vec4 bare = mean(traced(shot).radiance);
    scene::Material sheet =
        material(Vec3(0.0F), 1.0F, 1.0F);  // a black metal reflects its grazing Fresnel alone
    sheet.alpha_mode = scene::AlphaMode::blend;
    sheet.values.opacity = opacity;
    sheet.unlit = true;  // black, without even that
    add(shot.scene, quad(2.0F), sheet, glm::translate(math::Mat4(1.0F), Vec3(0, 0, 0.5F)));
    const float through = (1.0F - opacity) * (1.0F - opacity);
    const Vec4 seen = mean(traced(shot).radiance);
    EXPECT_NEAR(seen.x, bare.x * through, 0.01F * bare.x);
    EXPECT_NEAR(seen.w, 1.0F, 1e-6F);
}

TEST(Reference, TheCameraSeesNoBackOfWhatIsSingleSidedButLightDoes) {
    TraceShot shot{.scene = scene_of(quad(2.0F), material(Vec3(0.5F), 0.0F, 1.0F))};
    shot.scene.instances[0].world_from_object =
        glm::rotate(math::Mat4(1.0F), math::pi, Vec3(0, 1, 0));
    EXPECT_EQ(mean(traced(shot).radiance).w, 0.0F);
    shot.scene.materials[0].double_sided = true;
    EXPECT_EQ(mean(traced(shot).radiance).w, 1.0F);
}

TEST(Reference, AnEmptySceneIsItsBackground) {
    TraceShot shot{.scene = {}, .latlong = constant_environment(Vec3(0.25F))};
    EXPECT_EQ(mean(traced(shot).radiance), Vec4(0.0F));
    shot.shows_environment = true;
    const Vec4 shown = mean(traced(shot).radiance);
    EXPECT_NEAR(shown.x, 0.25F, 1e-6F);
    EXPECT_EQ(shown.w, 1.0F);
}

// Where the environment is alike all around, however blurred it is itself; of a half sky, the
// horizon blurs.
TEST(Reference, ABlurredBackgroundKeepsItsMeanAndSoftensItsEdges) {
    auto halves = std::make_shared<image::Image>(math::Extent{256, 128}, 3, image::Sample::f32);
    const auto values = halves->as<float>();
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = i < values.size() / 2 ? 1.0F : 0.0F;
    base::ThreadPool pool;
    const scene::Environment environment{"test", halves};
    scene::Camera camera = camera_on_z(0.0F, 1.0F);
    camera.projection = scene::Projection::perspective;
    camera.yfov_rad = 1.5F;
    camera.far_m = 0.0F;
    const scene::Scene nothing;
    const auto tracer = trace::Tracer::create({.scene = nothing,
                                               .environment = environment,
                                               .camera = camera,
                                               .background_blur = 0.5F,
                                               .brdf = {}},
                                              {}, pool);
    ASSERT_TRUE(tracer);
    const auto out = tracer->trace({.picture = {32, 32}, .size = {32, 32}, .samples = 256}, pool);
    EXPECT_NEAR(mean(out.radiance).x, 0.5F, 5e-3F);
    const float above = pixel(out.radiance, 16, 12).x;
    EXPECT_GT(above, 0.55F);
    EXPECT_LT(above, 0.95F);
}

}  // namespace
}  // namespace facet::test
