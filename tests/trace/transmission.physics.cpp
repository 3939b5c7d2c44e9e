// Light through surfaces against what is known on paper.
// SPDX-License-Identifier: MIT
#include "scene/lobes.h"
#include "support/trace_harness.h"
#include "trace/bsdf.h"
#include "trace/sequence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace facet::test {
namespace {

using math::Vec3;
using math::Vec4;

scene::Material glass(float roughness, float thickness_m) {
    scene::Material out = material(Vec3(1.0F), 0.0F, roughness);
    out.values.transmission = 1.0F;
    out.values.thickness_m = thickness_m;
    return out;
}

/// Mean radiance of a sphere's pixels in white light from everywhere.
Vec3 in_furnace(const scene::Material& of, std::uint32_t samples = 64) {
    TraceShot shot{.scene = scene_of(sphere(96), of), .latlong = constant_environment(Vec3(1.0F))};
    shot.scene.materials.front().double_sided = !scene::has_volume(of);
    shot.settings.picture = shot.settings.size = {32, 32};
    shot.settings.samples = samples;
    const auto out = traced(shot);
    EXPECT_EQ(out.not_finite, 0U);
    const Vec4 sum = mean(out.radiance);
    return Vec3(sum) / sum.w;
}

TEST(Transmission, AGlassSphereVanishesInAFurnace) {
    for (const float thickness_m : {0.0F, 1.0F})
        for (const float roughness : {0.0F, 0.2F, 0.5F, 1.0F}) {
            const float mean = in_furnace(glass(roughness, thickness_m)).x;
            EXPECT_NEAR(mean, 1.0F, 0.015F)
                << "thickness " << thickness_m << " roughness " << roughness;
        }
}

/// Seen at one cosine: what the samples keep of white light, and the sum over all directions of
/// what evaluate() sends on.
TEST(Transmission, TheBoundaryOfAVolumeSendsOnAllLight) {
    const trace::Model model{tables::BrdfChoice{}};
    for (const bool front : {true, false})
        for (const float roughness : {0.5F, 1.0F})
            for (const float cosine : {0.05F, 0.3F, 0.95F}) {
                trace::Surface surface;
                surface.normal = surface.face_normal = {0.0F, 0.0F, 1.0F};
                surface.front = front;
                surface.has_volume = true;
                surface.transmission = 1.0F;
                surface.roughness = roughness;
                const Vec3 to_eye(std::sqrt(1.0F - cosine * cosine), 0.0F, cosine);
                const trace::Bsdf bsdf(model, surface, to_eye);
                float kept = 0.0F;
                float sum = 0.0F;
                constexpr std::uint32_t count = 20000;
                for (std::uint32_t i = 0; i < count; ++i) {
                    trace::Sequence sequence(1, i, 0);
                    const math::Vec2 u = sequence.next_pair();
                    const auto sample = bsdf.sample(u, sequence.next());
                    if (sample.is_valid)
                        kept += sample.scattered.of_environment.x / sample.scattered.pdf;
                    const math::Vec2 at = sequence.next_pair();
                    const float z = 2.0F * at.x - 1.0F;
                    const float r = std::sqrt(1.0F - z * z);
                    const float phi = 2.0F * math::pi * at.y;
                    sum +=
                        4.0F * math::pi *
                        bsdf.evaluate({r * std::cos(phi), r * std::sin(phi), z}).of_environment.x;
                }
                EXPECT_NEAR(kept / count, 1.0F, 0.01F)
                    << front << " roughness " << roughness << " cosine " << cosine;
                EXPECT_NEAR(sum / count, 1.0F, 0.06F)
                    << front << " roughness " << roughness << " cosine " << cosine;
            }
}

TEST(Transmission, WhatDispersesLightKeepsItInEveryChannel) {
    scene::Material prism = glass(0.0F, 1.0F);
    prism.values.dispersion = 2.0F;
    const Vec3 mean = in_furnace(prism);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], 1.0F, 0.02F);
}

TEST(Transmission, SharesAddUpToOne) {
    scene::Material leaf = material(Vec3(1.0F), 0.0F, 0.4F);
    leaf.values.diffuse_transmission = 0.6F;
    EXPECT_NEAR(in_furnace(leaf).x, 1.0F, 0.01F);
    leaf.values.transmission = 0.5F;
    EXPECT_NEAR(in_furnace(leaf).x, 1.0F, 0.01F);
    leaf.values.clearcoat = 1.0F;
    leaf.values.clearcoat_roughness = 0.3F;
    EXPECT_NEAR(in_furnace(leaf).x, 1.0F, 0.01F);
    scene::Material half = glass(0.0F, 1.0F);
    half.values.transmission = 0.5F;
    EXPECT_NEAR(in_furnace(half).x, 1.0F, 0.01F);
}

TEST(Transmission, AVolumeAbsorbsByTheWayThroughIt) {
    scene::Material volume = glass(0.0F, 1.0F);
    volume.values.ior = 1.0F;
    volume.values.attenuation_distance_m = 0.5F;
    volume.values.attenuation_color = {0.8F, 0.5F, 0.2F};
    TraceShot shot{.scene = scene_of(sphere(256), volume),
                   .latlong = constant_environment(Vec3(1.0F))};
    shot.settings.picture = shot.settings.size = {65, 65};
    shot.settings.samples = 16;
    const Vec4 middle = pixel(traced(shot).radiance, 32, 32);
    for (int c = 0; c < 3; ++c)  // Beer-Lambert over the diameter, 2 m
        EXPECT_NEAR(middle[c], std::pow(volume.values.attenuation_color[c], 4.0F), 0.005F) << c;
}

TEST(Scattering, AVolumeThatAbsorbsNothingSendsOnAllLight) {
    for (const float anisotropy : {0.0F, 0.7F})
        for (const float distance_m : {1.0F, 0.1F}) {
            scene::Material milk = material(Vec3(1.0F), 0.0F, 0.4F);
            milk.values.diffuse_transmission = 1.0F;
            milk.values.thickness_m = 1.0F;
            milk.values.attenuation_color = Vec3(0.3678794F);  // extinction is one over the way
            milk.values.attenuation_distance_m = distance_m;
            milk.values.scatter_color = Vec3(1.0F);
            milk.values.scatter_anisotropy = anisotropy;
            EXPECT_NEAR(in_furnace(milk, 32).x, 1.0F, 0.015F) << anisotropy << ' ' << distance_m;
            milk.values.diffuse_transmission = 0.0F;
            milk.values.transmission = 1.0F;
            EXPECT_NEAR(in_furnace(milk, 32).x, 1.0F, 0.02F) << anisotropy << ' ' << distance_m;
        }
}

// Where the way between events is short beside the ball, its surface is flat to light: it sends
// back the colour that the material asks for (of light that enters and leaves as Lambert's does).
TEST(Scattering, ADenseVolumeHasItsColor) {
    scene::Material wax = material(Vec3(1.0F), 0.0F, 1.0F);
    wax.values.ior = 1.0F;
    wax.values.specular = 0.0F;
    wax.values.diffuse_transmission = 1.0F;
    wax.values.thickness_m = 1.0F;
    wax.values.attenuation_color = Vec3(0.3678794F);
    wax.values.attenuation_distance_m = 0.01F;
    wax.values.scatter_color = {0.8F, 0.5F, 0.2F};
    const Vec3 mean = in_furnace(wax, 64);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], wax.values.scatter_color[c], 0.04F) << c;
}

TEST(Transmission, ThinGlassDimsLightByItsFresnelAndColorAndDoesNotBendIt) {
    scene::Material pane = glass(0.0F, 0.0F);
    pane.values.base_color = {0.9F, 0.6F, 0.3F};
    pane.double_sided = true;
    TraceShot shot{.scene = scene_of(sphere(96), pane),
                   .latlong = constant_environment(Vec3(1.0F))};
    shot.settings.picture = shot.settings.size = {65, 65};
    shot.settings.samples = 2048;
    const Vec4 middle = pixel(traced(shot).radiance, 32, 32);
    // Two panes: what each reflects goes to and fro between them.
    constexpr float f = 0.04F;
    for (int c = 0; c < 3; ++c) {
        const float t = pane.values.base_color[c] * (1.0F - f);
        EXPECT_NEAR(middle[c], f + t * t * 1.0F / (1.0F - f * f) + t * t * f / (1.0F - f * f),
                    0.01F)
            << c;
    }
}

/// A square floor of 2 m, white, under a square light of 20 cm that shines down on it from 1 m.
TraceShot lit_floor(bool is_mesh) {
    TraceShot shot{.scene = scene_of(quad(2.0F), material(Vec3(1.0F), 0.0F, 1.0F))};
    shot.scene.materials.front().values.specular = 0.0F;
    shot.camera = camera_on_z(0.5F, 0.2F);
    shot.settings.picture = shot.settings.size = {8, 8};
    shot.settings.samples = 256;
    if (!is_mesh) {
        shot.scene.lights = {{.kind = tables::LightKind::rect,
                              .intensity = 30.0F,
                              .position_m = {0.0F, 0.0F, 1.0F},
                              .direction = {0.0F, 0.0F, -1.0F},
                              .width_m = 0.2F,
                              .height_m = 0.2F}};
        return shot;
    }
    scene::Material lamp = material(Vec3(0.0F), 0.0F, 1.0F);
    lamp.values.emissive = Vec3(30.0F);
    add(shot.scene, quad(0.2F), lamp,
        glm::rotate(glm::translate(math::Mat4(1.0F), Vec3(0.0F, 0.0F, 1.0F)), math::pi,
                    Vec3(1.0F, 0.0F, 0.0F)));
    return shot;
}

// Rays that meet the light straight through the glass are weighed by how they were drawn before it.
TEST(Transmission, ALightBehindThinClearGlassCountsOnce) {
    for (const char* const lamp : {"listed", "hidden by nothing", "mesh"}) {
        TraceShot shot = lit_floor(lamp == std::string("mesh"));
        for (scene::Light& light : shot.scene.lights)
            light.casts_shadow = lamp == std::string("listed");
        const float bare = mean(traced(shot).radiance).x;
        EXPECT_NEAR(bare, 30.0F * 0.04F / math::pi, 0.04F) << "a little less than below it";
        scene::Material pane = glass(0.0F, 0.0F);
        pane.values.specular = 0.0F;  // whose reflections would come on top
        pane.double_sided = true;
        for (const float height_m : {0.6F, 0.95F}) {
            TraceShot behind = shot;
            add(behind.scene, quad(1.0F), pane,
                glm::translate(math::Mat4(1.0F), Vec3(0.0F, 0.0F, height_m)));
            EXPECT_NEAR(mean(traced(behind).radiance).x / bare, 1.0F, 0.02F)
                << lamp << " glass at " << height_m;
        }
    }
}

// 30 nit through one boundary, and 0.8 m of what takes light.
TEST(Transmission, ALightWithinAVolumeIsDimmedByItsWay) {
    scene::Material volume = glass(0.0F, 1.0F);
    volume.values.ior = 1.0F;
    volume.values.attenuation_distance_m = 0.5F;
    volume.values.attenuation_color = {0.8F, 0.5F, 0.2F};
    TraceShot shot{.scene = scene_of(sphere(256), volume)};
    shot.scene.lights = {{.kind = tables::LightKind::sphere, .intensity = 30.0F, .radius_m = 0.2F}};
    shot.settings.picture = shot.settings.size = {65, 65};
    const Vec4 middle = pixel(traced(shot).radiance, 32, 32);
    for (int c = 0; c < 3; ++c) {
        const float expected = 30.0F * std::pow(volume.values.attenuation_color[c], 1.6F);
        EXPECT_NEAR(middle[c], expected, 0.01F * expected) << c;
    }
}

// A clear ball of half the size within one that absorbs: half of the way is left.
TEST(Transmission, AVolumeGoesOnBehindOneThatIsWithinIt) {
    scene::Material outer = glass(0.0F, 1.0F);
    outer.values.ior = 1.0F;
    outer.values.attenuation_distance_m = 0.5F;
    outer.values.attenuation_color = {0.8F, 0.5F, 0.2F};
    scene::Material inner = glass(0.0F, 1.0F);
    inner.values.ior = 1.0F;
    TraceShot shot{.scene = scene_of(sphere(256), outer),
                   .latlong = constant_environment(Vec3(1.0F))};
    add(shot.scene, sphere(256), inner, glm::scale(math::Mat4(1.0F), Vec3(0.5F)));
    shot.settings.picture = shot.settings.size = {65, 65};
    shot.settings.samples = 256;
    const image::Image radiance = traced(shot).radiance;
    Vec4 middle(0.0F);  // of several pixels, as paths may end by chance
    for (std::uint32_t y = 30; y < 35; ++y)
        for (std::uint32_t x = 30; x < 35; ++x) middle += pixel(radiance, x, y) / 25.0F;
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(middle[c], std::pow(outer.values.attenuation_color[c], 2.0F), 0.02F) << c;
}

/// Glass with a ball of another index within, in a picture of an uneven sky.
image::Image glass_around(float inner_ior) {
    scene::Material outer = glass(0.0F, 1.0F);
    TraceShot shot{.scene = scene_of(sphere(256), outer),
                   .latlong = constant_environment(Vec3(1.0F))};
    auto above = std::make_shared<image::Image>(*shot.latlong);
    const auto nit = above->as<float>();
    std::fill(nit.begin() + static_cast<std::ptrdiff_t>(nit.size() / 2), nit.end(), 0.0F);
    shot.latlong = above;
    if (inner_ior > 0.0F) {
        scene::Material inner = outer;
        inner.values.ior = inner_ior;
        add(shot.scene, sphere(256), inner, glm::scale(math::Mat4(1.0F), Vec3(0.6F)));
    }
    shot.settings.samples = 64;
    return traced(shot).radiance;
}

TEST(Transmission, WhatHasTheIndexOfTheGlassAroundItIsNotSeen) {
    const image::Image alone = glass_around(0.0F);
    const auto difference = [&](const image::Image& other) {
        const auto a = alone.as<float>();
        const auto b = other.as<float>();
        double sum = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i)
            sum += static_cast<double>(std::fabs(a[i] - b[i]));
        return sum / static_cast<double>(a.size());
    };
    EXPECT_LT(difference(glass_around(1.5F)), 0.02);
    EXPECT_GT(difference(glass_around(1.3F)), 0.05);
}

TEST(Transmission, AMirrorAndGlassShowTheDiscOfTheSun) {
    scene::Material mirror = material(Vec3(1.0F), 1.0F, 0.0F);
    scene::Material pane = glass(0.0F, 0.0F);
    pane.values.specular = 0.0F;
    pane.double_sided = true;
    constexpr float angle_rad = 0.3F;
    const float disc_sr = 2.0F * math::pi * (1.0F - std::cos(0.5F * angle_rad));
    for (const bool is_mirror : {true, false})
        for (const float off_rad : {0.0F, 0.14F, 0.16F}) {
            TraceShot shot{.scene = scene_of(quad(2.0F), is_mirror ? mirror : pane)};
            const float away = is_mirror ? -1.0F : 1.0F;
            shot.scene.lights = {{.kind = tables::LightKind::directional,
                                  .intensity = 5.0F,
                                  .direction = {std::sin(off_rad), 0.0F, away * std::cos(off_rad)},
                                  .angle_rad = angle_rad}};
            const float expected = off_rad < 0.5F * angle_rad ? 5.0F / disc_sr : 0.0F;
            EXPECT_NEAR(mean(traced(shot).radiance).x, expected, 0.05F) << is_mirror << off_rad;
        }
}

/// With a direction around the y axis.
scene::Mesh brushed_sphere() {
    scene::Mesh mesh = sphere(96);
    for (const Vec3& n : mesh.normals) {
        const Vec3 along = math::cross(Vec3(0.0F, 1.0F, 0.0F), n);
        const float length = math::length(along);
        mesh.tangents.emplace_back(length > 1e-4F ? along / length : Vec3(1.0F, 0.0F, 0.0F), 1.0F);
    }
    return mesh;
}

TEST(Anisotropy, ABrushedSphereVanishesInAFurnace) {
    for (const float metallic : {0.0F, 1.0F})
        for (const float roughness : {0.1F, 0.4F, 0.7F})
            for (const float strength : {0.3F, 0.7F, 1.0F}) {
                scene::Material brushed = material(Vec3(1.0F), metallic, roughness);
                brushed.values.anisotropy = strength;
                TraceShot shot{.scene = scene_of(brushed_sphere(), brushed),
                               .latlong = constant_environment(Vec3(1.0F))};
                shot.settings.samples = 64;
                const Vec4 sum = mean(traced(shot).radiance);
                EXPECT_NEAR(sum.x / sum.w, 1.0F, 0.02F)
                    << metallic << " roughness " << roughness << " strength " << strength;
            }
}

TEST(Anisotropy, BrushedThinGlassVanishesInAFurnace) {
    for (const float roughness : {0.2F, 0.5F}) {
        scene::Material brushed = glass(roughness, 0.0F);
        brushed.values.anisotropy = 1.0F;
        brushed.double_sided = true;
        TraceShot shot{.scene = scene_of(brushed_sphere(), brushed),
                       .latlong = constant_environment(Vec3(1.0F))};
        shot.settings.samples = 128;
        const Vec4 sum = mean(traced(shot).radiance);
        EXPECT_NEAR(sum.x / sum.w, 1.0F, 0.02F) << roughness;
    }
}

TEST(Iridescence, AFilmKeepsAllLightOfAWhiteSphere) {
    for (const float thickness_nm : {0.0F, 200.0F, 550.0F}) {
        scene::Material soap = material(Vec3(1.0F), 0.0F, 0.2F);
        soap.values.iridescence = 1.0F;
        soap.values.iridescence_thickness_max_nm = thickness_nm;
        const Vec3 mean = in_furnace(soap, 64);
        // The diffuse lobe gets what the strongest channel leaves.
        for (int c = 0; c < 3; ++c) {
            EXPECT_LT(mean[c], 1.005F);
            EXPECT_GT(mean[c], 0.85F);
        }
    }
}

}  // namespace
}  // namespace facet::test
