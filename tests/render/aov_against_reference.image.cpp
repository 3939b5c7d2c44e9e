// AOVs of the rasteriser against those of the reference: two ways to the first surface, one table
// of values. SPDX-License-Identifier: MIT
#include "support/frame_harness.h"
#include "support/trace_harness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace facet::test {
namespace {

std::vector<tables::Aov> all_aovs() {
    std::vector<tables::Aov> all;
    for (std::size_t i = 0; i < tables::aovs.size(); ++i)
        if (tables::aovs[i].kind != tables::AovKind::light_path)
            all.push_back(static_cast<tables::Aov>(i));
    return all;
}

// The sphere turned and stretched, so that normals and positions go through its matrix.
TEST(AovAgainstReference, EveryAovIsTheSameAwayFromEdges) {
    scene::Material stuff = material({0.8F, 0.5F, 0.2F}, 0.4F, 0.7F);
    stuff.values.emissive = {0.1F, 0.2F, 0.3F};
    scene::Scene scene = scene_of(sphere(96), stuff);
    scene.instances[0].world_from_object =
        glm::rotate(math::Mat4(1.0F), 0.5F, math::Vec3(0, 0, 1)) *
        glm::scale(math::Mat4(1.0F), {0.9F, 0.5F, 0.7F});
    Harness harness;
    const scene::KeyLight key_light{{1.0F, 1.5F, 2.0F, 1.0F}};
    const auto raster =
        harness.draw({.scene = scene, .samples = 8, .aovs = all_aovs(), .key_light = key_light});
    ASSERT_TRUE(raster) << base::to_line(raster.error());
    base::ThreadPool pool;
    TraceShot shot{.scene = scene};
    const scene::Environment environment{"test", shot.latlong};
    const auto tracer = trace::Tracer::create({.scene = scene,
                                               .environment = environment,
                                               .camera = shot.camera,
                                               .brdf = {},
                                               .key_light = key_light},
                                              {}, pool);
    ASSERT_TRUE(tracer);
    const auto layers = tracer->aovs(shot.settings, all_aovs(), pool);
    ASSERT_EQ(layers.size(), raster->aovs.size());
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const auto a = raster->aovs[i].image.as<float>();
        const auto b = layers[i].image.as<float>();
        EXPECT_EQ(raster->aovs[i].name, layers[i].name);
        ASSERT_EQ(a.size(), b.size());
        std::size_t differing = 0;
        for (std::size_t k = 0; k < a.size(); ++k)
            // The G-buffer holds metallic, roughness and AO in 8 bits and normals in 16.
            if (!(std::fabs(a[k] - b[k]) <= 4e-3F) && a[k] != b[k]) ++differing;
        // Pixels that the outline crosses: 2 pi times half the picture's width, twice for means of
        // few samples.
        EXPECT_LE(differing, layers[i].image.channels * 400U) << layers[i].name;
    }
}

}  // namespace
}  // namespace facet::test
