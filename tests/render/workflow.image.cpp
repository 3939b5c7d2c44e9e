// Materials in the lecture's two workflows show the same.
// SPDX-License-Identifier: MIT
#include "scene/workflow.h"

#include "base/thread_pool.h"
#include "scene/load.h"
#include "scene/save.h"
#include "support/rendered.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace facet::render {
namespace {

using scene::Workflow;

/// The scene of `source` in that workflow, saved as `target`; how many of its materials are in it.
std::size_t convert(const std::string& source, const std::filesystem::path& target, Workflow to) {
    base::ThreadPool pool(1);
    const auto loaded = scene::load(source, {}, {}, pool);
    EXPECT_TRUE(loaded) << base::to_line(loaded.error());
    if (!loaded) return 0;
    scene::Scene converted = loaded->scene;
    base::Warnings warnings;
    scene::convert(converted, to, warnings);
    EXPECT_TRUE(warnings.empty());
    const auto saved = scene::save({.source = source,
                                    .original = loaded->scene,
                                    .edited = converted,
                                    .target = target,
                                    .options = {}},
                                   {});
    EXPECT_TRUE(saved) << base::to_line(saved.error());
    const auto again = scene::load(target.string(), {}, {}, pool);
    EXPECT_TRUE(again && again->warnings.empty());
    if (!again) return 0;
    EXPECT_FALSE(scene::has_other(again->scene, to));
    return static_cast<std::size_t>(
        std::ranges::count_if(again->scene.materials, [&](const scene::Material& m) {
            return m.has_glossiness == (to == Workflow::specular_glossiness);
        }));
}

double difference(const image::Image& a, const image::Image& b) {
    const auto x = a.as<std::uint8_t>();
    const auto y = b.as<std::uint8_t>();
    if (x.size() != y.size()) return 1.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += std::pow((x[i] - y[i]) / 255.0, 2.0);
    return std::sqrt(sum / static_cast<double>(x.size()));
}

// There and back; textures are baked in 8 bits, so not to the bit.
TEST(Workflow, ARoundTripShowsTheSame) {
    const support::TemporaryFolder folder;
    const std::string there = (folder / "there.glb").string();
    const std::string back = (folder / "back.gltf").string();
    for (const std::string source : {"builtin:showcase", "builtin:spheres"}) {
        const std::size_t count = convert(source, there, Workflow::specular_glossiness);
        EXPECT_GT(count, 1U);
        EXPECT_EQ(convert(there, back, Workflow::metallic_roughness), count);
        Request request{.scene = source};
        request.settings.size = {120, 80};
        request.settings.quality = "draft";
        request.settings.exposure = "1";
        request.settings.shadows = "off";  // rays draw other numbers for other lobes
        const auto original = test::rendered(request);
        ASSERT_TRUE(original);
        for (const std::string& scene : {there, back}) {
            request.scene = scene;
            const auto converted = test::rendered(request);
            ASSERT_TRUE(converted);
            EXPECT_LT(difference(original->display, converted->display), 0.01) << source << scene;
        }
    }
}

}  // namespace
}  // namespace facet::render
