// Light by the way it took: the parts add up to the beauty in raster and reference, and each is
// where its definition says. SPDX-License-Identifier: MIT
#include "render/render.h"
#include "support/frame_harness.h"
#include "support/trace_harness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace facet::test {
namespace {

using math::Vec3;
using tables::Aov;

std::vector<Aov> light_paths() {
    std::vector<Aov> all;
    for (std::size_t i = 0; i < tables::aovs.size(); ++i)
        if (tables::aovs[i].kind == tables::AovKind::light_path) all.push_back(static_cast<Aov>(i));
    return all;
}
std::vector<std::string> light_path_names() {
    std::vector<std::string> names;
    for (const Aov aov : light_paths()) names.emplace_back(tables::row(aov).key);
    return names;
}

const image::Layer& layer(const std::vector<image::Layer>& layers, std::string_view name) {
    for (const image::Layer& each : layers)
        if (each.name == name) return each;
    ADD_FAILURE() << "no layer " << name;
    return layers.front();
}
Vec3 value(const std::vector<image::Layer>& layers, Aov aov, std::uint32_t x, std::uint32_t y) {
    const image::Image& image = layer(layers, tables::row(aov).key).image;
    const float* v = image.as<float>().data() + (std::size_t{y} * image.size.width + x) * 3;
    return {v[0], v[1], v[2]};
}

/// Pixels whose parts do not add up to the beauty, to 1e-3 of its largest channel (contract).
std::size_t off_pixels(const image::Image& beauty, const std::vector<image::Layer>& layers) {
    const auto whole = beauty.as<float>();
    std::size_t off = 0;
    for (std::size_t i = 0; i < whole.size() / 4; ++i) {
        Vec3 sum(0.0F);
        for (const std::string& name : light_path_names()) {
            const float* v = layer(layers, name).image.as<float>().data() + i * 3;
            sum += Vec3(v[0], v[1], v[2]);
        }
        const Vec3 pixel(whole[i * 4], whole[i * 4 + 1], whole[i * 4 + 2]);
        const float most = std::max({pixel.x, pixel.y, pixel.z});
        const Vec3 gap = glm::abs(sum - pixel);
        if (!(std::max({gap.x, gap.y, gap.z}) <= 1e-3F * most + 1e-12F)) ++off;
    }
    return off;
}

/// Sum of a path's light over the picture.
double total(const std::vector<image::Layer>& layers, Aov aov) {
    double sum = 0.0;
    for (const float v : layer(layers, tables::row(aov).key).image.as<float>())
        sum += static_cast<double>(v);
    return sum;
}

class LightPathsOfAFile : public testing::TestWithParam<std::string> {};

TEST_P(LightPathsOfAFile, AddUpToTheBeautyInRasterAndReference) {
    std::string scene = GetParam();
    if (!scene.starts_with("builtin:")) {
        scene = FACET_SOURCE_DIR "/../shared/assets/models/" + scene;
        if (!std::filesystem::exists(scene)) GTEST_SKIP() << "not here: " << scene;
    }
    base::Log log;
    for (const char* reference : {"", "3"})
        for (const char* background : {"env", "#406080"}) {
            render::Request request{.scene = scene, .want_linear = true};
            request.settings.size = {80, 60};
            request.settings.samples = 2;
            request.settings.reference = reference;
            request.settings.background = background;
            request.settings.light = {"point:candela=40,position=1 2 2"};
            request.settings.aov = light_path_names();
            const auto picture = render::render(request, log);
            ASSERT_TRUE(picture) << base::to_line(picture.error());
            EXPECT_EQ(off_pixels(picture->layers.front().image, picture->layers), 0U)
                << "reference " << reference << ", background " << background;
            if (request.settings.background != "env") continue;
            request.settings.aov = {};
            const auto alone = render::render(request, log);
            ASSERT_TRUE(alone);
            EXPECT_EQ(alone->layers.front().image.bytes, picture->layers.front().image.bytes)
                << "the beauty is the same without them";
        }
}

INSTANTIATE_TEST_SUITE_P(Scenes, LightPathsOfAFile,
                         testing::Values("builtin:showcase", "builtin:spheres", "builtin:cornell",
                                         "builtin:furnace",
                                         "AlphaBlendModeTest/AlphaBlendModeTest.glb"));

/// A quad that fills the picture, before an environment of 1 nit.
struct Scenes {
    scene::Scene scene = scene_of(quad(4.0F), material({0.5F, 0.5F, 0.5F}, 0.0F, 0.5F));
    Harness harness;

    std::vector<image::Layer> raster(Vec3 environment, frame::BackgroundKind kind) {
        const auto picture = harness.draw({.scene = scene,
                                           .latlong = constant_environment(environment),
                                           .background = {.kind = kind},
                                           .aovs = light_paths()});
        EXPECT_TRUE(picture) << base::to_line(picture.error());
        EXPECT_EQ(off_pixels(picture->radiance, picture->aovs), 0U);
        return picture->aovs;
    }
    std::vector<image::Layer> reference(Vec3 environment, bool shows_environment) {
        TraceShot shot{.scene = scene,
                       .latlong = constant_environment(environment),
                       .shows_environment = shows_environment};
        shot.settings.light_paths = light_paths();
        const auto picture = traced(shot);
        EXPECT_EQ(off_pixels(picture.radiance, picture.light_paths), 0U);
        return picture.light_paths;
    }
};

TEST(LightPaths, ALightIsDirectAndTheEnvironmentIsNot) {
    Scenes scenes;
    for (const bool has_light : {true, false}) {
        scenes.scene.lights.clear();
        if (has_light) scenes.scene.lights.push_back({.intensity = 2.0F});
        const Vec3 around(has_light ? 0.0F : 1.0F);
        for (const auto& layers : {scenes.raster(around, frame::BackgroundKind::none),
                                   scenes.reference(around, false)}) {
            EXPECT_EQ(value(layers, Aov::diffuse_direct, 32, 32).x > 0.1F, has_light);
            EXPECT_EQ(value(layers, Aov::specular_direct, 32, 32).x > 0.01F, has_light);
            EXPECT_EQ(value(layers, Aov::diffuse_indirect, 32, 32).x > 0.1F, !has_light);
            EXPECT_EQ(value(layers, Aov::specular_indirect, 32, 32).x > 0.01F, !has_light);
            EXPECT_EQ(value(layers, Aov::emission, 32, 32), Vec3(0.0F));
        }
    }
}

// k_d is 0 where metallic is 1.
TEST(LightPaths, AMetalHasNoDiffuseLight) {
    Scenes scenes;
    scenes.scene.materials[0].values.metallic = 1.0F;
    scenes.scene.lights = {{.intensity = 2.0F}};
    for (const auto& layers : {scenes.raster(Vec3(1.0F), frame::BackgroundKind::none),
                               scenes.reference(Vec3(1.0F), false)}) {
        EXPECT_EQ(value(layers, Aov::diffuse_direct, 32, 32), Vec3(0.0F));
        EXPECT_EQ(value(layers, Aov::diffuse_indirect, 32, 32), Vec3(0.0F));
        EXPECT_GT(value(layers, Aov::specular_direct, 32, 32).x, 0.1F);
        EXPECT_GT(value(layers, Aov::specular_indirect, 32, 32).x, 0.1F);
    }
}

// An unlit colour of 0.5 at an opacity of 0.25 before 1 nit: 0.125 emitted, 0.75 of what is behind.
TEST(LightPaths, ABlendedSurfaceAttenuatesWhatIsBehindInItsOwnPath) {
    Scenes scenes;
    scene::Material& stuff = scenes.scene.materials[0];
    stuff.alpha_mode = scene::AlphaMode::blend;
    stuff.values.opacity = 0.25F;
    stuff.unlit = true;
    const auto raster = scenes.raster(Vec3(1.0F), frame::BackgroundKind::environment);
    EXPECT_NEAR(value(raster, Aov::emission, 32, 32).x, 0.125F, 1e-4F);
    EXPECT_NEAR(value(raster, Aov::background, 32, 32).x, 0.75F, 1e-3F);
    // Over the whole picture: 64 x 64 pixels of 16 samples, standard error 0.0017.
    const auto reference = scenes.reference(Vec3(1.0F), true);
    EXPECT_NEAR(total(reference, Aov::background) / (64.0 * 64.0 * 3.0), 0.75, 0.006);
}

// A mesh that emits lights its neighbour directly, whether it was drawn or met, and is itself seen
// as emission.
TEST(LightPaths, AMeshThatEmitsIsADirectLightInTheReference) {
    Scenes scenes;
    scene::Material lamp = material(Vec3(0.0F), 0.0F, 1.0F);
    lamp.values.emissive = Vec3(5.0F);
    scenes.scene.materials.push_back(lamp);
    scene::Mesh shade = quad(1.0F);
    shade.material = {1};
    scenes.scene.meshes.push_back(shade);
    // Beside the camera's view, above the quad and facing it.
    scenes.scene.instances.push_back(
        {.mesh = {1},
         .world_from_object = glm::rotate(glm::translate(math::Mat4(1.0F), Vec3(1.6F, 0.0F, 1.0F)),
                                          math::pi, Vec3(0.0F, 1.0F, 0.0F))});
    const auto layers = scenes.reference(Vec3(0.0F), false);
    EXPECT_GT(value(layers, Aov::diffuse_direct, 40, 32).x, 0.01F);
    EXPECT_EQ(total(layers, Aov::emission), 0.0) << "it is beside the view";
    EXPECT_EQ(total(layers, Aov::background), 0.0);
    // What comes back from the lamp's own 4 % of reflectance.
    EXPECT_LT(total(layers, Aov::diffuse_indirect), 0.02 * total(layers, Aov::diffuse_direct));
}

// A convex object's direct light is the same in both; the bound is what its whole picture is off
// by, see raster_against_reference.
TEST(LightPaths, DirectLightOfAConvexObjectSplitsAlikeInRasterAndReference) {
    Scenes scenes;
    for (const float metallic : {0.0F, 0.6F}) {
        scenes.scene = scene_of(sphere(96), material({0.8F, 0.5F, 0.2F}, metallic, 0.4F));
        scenes.scene.lights = {
            {.intensity = 2.0F, .direction = -math::direction_from(50.0F, 40.0F)}};
        const auto raster = scenes.raster(Vec3(0.0F), frame::BackgroundKind::none);
        const auto reference = scenes.reference(Vec3(0.0F), false);
        for (const Aov aov : {Aov::diffuse_direct, Aov::specular_direct})
            EXPECT_NEAR(total(raster, aov) / total(reference, aov), 1.0, 0.01)
                << tables::row(aov).key << " metallic " << metallic;
    }
}

}  // namespace
}  // namespace facet::test
