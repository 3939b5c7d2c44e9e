// The rasteriser against the reference where both know all light: one convex object in direct
// light. SPDX-License-Identifier: MIT
#include "brdf/choice.h"
#include "math/color.h"
#include "support/frame_harness.h"
#include "support/trace_harness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace facet::test {
namespace {

using math::Vec3;
using math::Vec4;

/// Every value of every slot, one at a time, and the lecture's set.
std::vector<std::pair<std::string, tables::BrdfChoice>> choices() {
    std::vector<std::pair<std::string, tables::BrdfChoice>> all{{"default", {}}};
    all.emplace_back("lecture", *brdf::parse_choice("lecture", brdf::Use::render));
    for (const tables::BrdfSlot& slot : tables::brdf_slots) {
        std::size_t index = 0;
        for (const tables::BrdfTerm& term : tables::brdf_terms) {
            if (term.slot != slot.key) continue;
            const std::size_t at = index++;
            if (term.notes.lesson || at == 0) continue;
            tables::BrdfChoice choice;
            slot.set(choice, at);
            all.emplace_back(std::string(slot.key) + "=" + std::string(term.name), choice);
        }
    }
    return all;
}

/// Root of the mean square of sRGB values in [0, 1] over the pixels that both cover whole.
double display_rmse(const image::Image& a, const image::Image& b) {
    double squares = 0.0;
    std::size_t count = 0;
    const auto va = a.as<float>();
    const auto vb = b.as<float>();
    const auto shown = [](float x) {
        return static_cast<double>(math::srgb_from_linear(std::min(std::max(x, 0.0F), 1.0F)));
    };
    for (std::size_t i = 0; i < va.size(); i += 4) {
        if (va[i + 3] < 1.0F || vb[i + 3] < 1.0F) continue;
        ++count;
        for (std::size_t c = 0; c < 3; ++c) {
            const double error = shown(va[i + c]) - shown(vb[i + c]);
            squares += error * error;
        }
    }
    EXPECT_GT(count, 1000U);
    return std::sqrt(squares / (3.0 * static_cast<double>(count)));
}

TEST(RasterAgainstReference, EveryBrdfShadesAConvexObjectAlikeInDirectLight) {
    Harness harness;
    double worst = 0.0;
    for (const auto& [name, choice] : choices())
        for (const auto& [metallic, roughness] :
             {std::pair{0.0F, 0.3F}, {1.0F, 0.25F}, {0.5F, 0.8F}, {1.0F, 0.0F}}) {
            scene::Scene scene =
                scene_of(sphere(128), material(Vec3(0.8F, 0.5F, 0.2F), metallic, roughness));
            scene.lights = {{.kind = tables::LightKind::directional,
                             .intensity = 2.0F,
                             .direction = -math::direction_from(50.0F, 40.0F)},
                            {.kind = tables::LightKind::point,
                             .intensity = 6.0F,
                             .position_m = {-2.0F, 0.5F, 2.0F}},
                            {.kind = tables::LightKind::spot,
                             .intensity = 4.0F,
                             .position_m = {0.0F, -2.0F, 2.0F},
                             .direction = math::normalize(Vec3(0.0F, 1.0F, -1.0F)),
                             .inner_cone_rad = 0.2F,
                             .outer_cone_rad = 0.5F}};
            const auto raster = harness.draw({.scene = scene, .samples = 16, .brdf = choice});
            ASSERT_TRUE(raster) << base::to_line(raster.error());
            TraceShot shot{.scene = scene, .brdf = choice};
            shot.settings.samples = 64;
            const auto reference = traced(shot);
            // What is left: where the facets of the tessellated sphere end and light skims, and the
            // G-buffer's 8-bit roughness and metallic.
            const double rmse = display_rmse(raster->radiance, reference.radiance);
            EXPECT_LE(rmse, 0.01) << name << " metallic " << metallic << " roughness " << roughness;
            worst = std::max(worst, rmse);
        }
    RecordProperty("worst_rmse", std::to_string(worst));
}

}  // namespace
}  // namespace facet::test
