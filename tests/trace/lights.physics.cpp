// Lights with a size against closed forms of the irradiance they give (independent tables).
// SPDX-License-Identifier: MIT
#include "trace/lights.h"

#include "support/reference_table.h"
#include "support/shapes.h"
#include "trace/sequence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace facet::trace {
namespace {

using math::Vec3;
using scene::Light;
using tables::LightKind;

/// The light of a row: the receiver is at the origin with its normal along +z; the light faces it.
Light light_of(const test::ReferenceRow& row) {
    const std::string shape = row.texts.at("shape");
    const auto p = [&](const char* column) { return static_cast<float>(row[column]); };
    Light light{.intensity = 1.0F};
    if (shape == "sphere") {
        const float angle = glm::radians(p("p1"));
        const float half = glm::radians(p("p2"));
        light.kind = LightKind::sphere;
        light.radius_m = std::sin(half);
        light.position_m = {std::sin(angle), 0.0F, std::cos(angle)};
    } else if (shape == "disk_parallel") {
        light.kind = LightKind::disk;
        light.position_m = {p("p2"), 0.0F, p("p1")};
        light.radius_m = p("p3");
        light.direction = {0.0F, 0.0F, -1.0F};
    } else if (shape == "rect_parallel") {
        light.kind = LightKind::rect;
        light.position_m = {p("p2"), 0.0F, p("p1")};
        light.width_m = p("p3");  // axes_of: x is level
        light.height_m = p("p4");
        light.direction = {0.0F, 0.0F, -1.0F};
    } else if (shape == "tube_parallel") {
        light.kind = LightKind::tube;
        light.position_m = {0.0F, p("p2"), p("p1")};
        light.width_m = p("p3");
        light.radius_m = p("p4");
        light.direction = {0.0F, 0.0F, -1.0F};
    }
    return light;
}

/// An upright rectangle stands beside the receiver; level is along x, up along the receiver's
/// normal. The scene's up is +y, so the whole is turned: the receiver's normal is +y.
Light upright(const test::ReferenceRow& row) {
    return {.kind = LightKind::rect,
            .intensity = 1.0F,
            .position_m = {0.0F, static_cast<float>(row["p2"]), static_cast<float>(row["p1"])},
            .direction = {0.0F, 0.0F, -1.0F},
            .width_m = static_cast<float>(row["p3"]),
            .height_m = static_cast<float>(row["p4"])};
}

/// Irradiance at the origin by drawing from the light alone; `deviation`: its standard error, from
/// batches.
double irradiance(const Light& light, const Vec3& normal, std::uint32_t draws) {
    scene::Scene scene;
    scene.lights = {light};
    const Textures textures;
    const Lights lights(scene, textures);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < draws; ++i) {
        Sequence sequence(3, i, 0);
        const auto choice = lights.choose(Vec3(0.0F), 0.5F);
        EXPECT_FLOAT_EQ(choice.probability, 1.0F);
        const LightSample sample = lights.sample(choice, Vec3(0.0F), sequence.next_pair(), 0.5F);
        const float cosine = std::max(0.0F, math::dot(sample.direction, normal));
        if (sample.pdf > 0.0F) sum += static_cast<double>(sample.light.x * cosine / sample.pdf);
    }
    return sum / draws;
}

TEST(AreaLights, IrradianceEqualsTheClosedForms) {
    for (const auto& row : test::reference_rows("area_lights_diffuse")) {
        const std::string shape = row.texts.at("shape");
        const bool stands = shape == "rect_upright";
        const Light light = stands ? upright(row) : light_of(row);
        const Vec3 normal = stands ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
        const double expected = row["E"];
        // The table's tube is of first order in its radius: radius / distance is 0.02 at most.
        // Scrambled Sobol points of a smooth integrand err far below 1 / sqrt(16384); 2e-3 is 15 %
        // of that.
        const double bound = shape == "tube_parallel" ? 0.025 : 2e-3;
        EXPECT_NEAR(irradiance(light, normal, 16384), expected, bound * expected + 1e-6)
            << row.shown;
    }
}

// The other half of multiple importance sampling: rays that happen to meet the light, weighted
// against its own draw, must see the same density that the draw has.
TEST(AreaLights, DensityOfARayThatMeetsTheLightIsThatOfItsDraw) {
    for (const auto& row : test::reference_rows("area_lights_diffuse")) {
        if (row.texts.at("shape") == "rect_upright" || row["E"] < 1e-3) continue;
        scene::Scene scene;
        scene.lights = {light_of(row)};
        const Textures textures;
        const Lights lights(scene, textures);
        const auto choice = lights.choose(Vec3(0.0F), 0.0F);
        int met = 0;
        for (std::uint32_t i = 0; i < 64; ++i) {
            Sequence sequence(8, i, 0);
            const LightSample sample =
                lights.sample(choice, Vec3(0.0F), sequence.next_pair(), 0.0F);
            if (!(sample.pdf > 0.0F)) continue;
            const Ray ray{Vec3(0.0F), sample.direction};
            // power_share(p, q) = 1 / (1 + (q / p)^2): with p = sample.pdf it is a half where the
            // densities agree.
            const float share =
                lights.met(ray, {.pdf = sample.pdf, .total_weight = choice.total_weight}).x;
            if (share == 0.0F) continue;  // drawn at the rim, missed by a rounding
            ++met;
            // The side of a tube 1 cm thick and 1 m away is known to 1e-5 rad: near its edge, where
            // the cosine is 1e-3, that is 1 % of the density, 2 % of its square.
            const float bound = scene.lights[0].kind == LightKind::tube ? 0.03F : 5e-3F;
            EXPECT_NEAR(share, 0.5F, bound) << row.shown;
        }
        EXPECT_GE(met, 60) << row.shown;
    }
}

TEST(AreaLights, OneSidedKindsAreDarkFromBehindAndSolidOnesFromInside) {
    for (const auto kind : {LightKind::rect, LightKind::disk}) {
        Light light{
            .kind = kind, .intensity = 1.0F, .position_m = {0, 0, 1}, .direction = {0, 0, 1}};
        EXPECT_EQ(irradiance(light, {0, 0, 1}, 256), 0.0);
    }
    for (const auto kind : {LightKind::sphere, LightKind::tube}) {
        Light light{.kind = kind, .intensity = 1.0F, .position_m = {0, 0, 0.05F}, .radius_m = 0.2F};
        EXPECT_EQ(irradiance(light, {0, 0, 1}, 256), 0.0);
    }
}

TEST(Lights, AreChosenByWhatTheyCanDoWhereItIsNeeded) {
    scene::Scene scene;
    scene.lights = {{.kind = LightKind::point, .intensity = 1.0F, .position_m = {1, 0, 0}},
                    {.kind = LightKind::point, .intensity = 1.0F, .position_m = {10, 0, 0}}};
    const Textures textures;
    const Lights lights(scene, textures);
    int near = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto choice = lights.choose(Vec3(0.0F), (static_cast<float>(i) + 0.5F) / 1000.0F);
        near += choice.light == 0 ? 1 : 0;
        EXPECT_NEAR(choice.probability, choice.light == 0 ? 100.0F / 101.0F : 1.0F / 101.0F, 1e-4F);
    }
    EXPECT_NEAR(near, 990, 1);
}

}  // namespace
}  // namespace facet::trace
