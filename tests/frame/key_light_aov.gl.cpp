// The BRDF's terms for the key light, read as AOVs, on a sphere whose cosines are known.
// SPDX-License-Identifier: MIT
#include "brdf/choice.h"
#include "brdf/terms.h"
#include "support/frame_harness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace facet::test {
namespace {

using math::Vec3;
using tables::Aov;

constexpr float roughness = 153.0F / 255.0F;  // the G-buffer holds 8 bits of it
constexpr float metallic = 51.0F / 255.0F;
const Vec3 base_color{0.8F, 0.5F, 0.2F};

/// A unit sphere seen along z by an orthographic camera: the pixel says where the normal points.
class KeyLightAovTest : public testing::Test {
protected:
    KeyLightAovTest()
        : shot{.scene = scene_of(sphere(256), material(base_color, metallic, roughness)),
               .camera = camera_on_z(4.0F, 1.0F),
               .aovs = {Aov::D, Aov::F, Aov::G, Aov::kd, Aov::ks, Aov::n_dot_v, Aov::n_dot_l,
                        Aov::n_dot_h, Aov::v_dot_h},
               .key_light = {math::Vec4(math::normalize(Vec3(1.0F, 2.0F, 2.0F)), 0.0F)}} {}

    struct Point {
        std::uint32_t x, y;
        Vec3 normal;
    };
    /// Away from the outline, where a pixel's normals are one.
    static std::vector<Point> points() {
        std::vector<Point> out;
        for (std::uint32_t y = 2; y < 64; y += 5)
            for (std::uint32_t x = 2; x < 64; x += 5) {
                const float a = (static_cast<float>(x) + 0.5F) / 32.0F - 1.0F;
                const float b = 1.0F - (static_cast<float>(y) + 0.5F) / 32.0F;
                const float c2 = 1.0F - a * a - b * b;
                if (c2 > 0.1F) out.push_back({x, y, {a, b, std::sqrt(c2)}});
            }
        return out;
    }
    Vec3 value(const Picture& picture, const char* name, const Point& at) {
        for (const image::Layer& layer : picture.aovs) {
            if (layer.name != name) continue;
            const std::size_t channels = layer.image.channels;
            const float* v =
                layer.image.as<float>().data() + (std::size_t{at.y} * 64 + at.x) * channels;
            return channels == 3 ? Vec3(v[0], v[1], v[2]) : Vec3(v[0]);
        }
        ADD_FAILURE() << "no AOV " << name;
        return Vec3(0.0F);
    }

    Harness harness;
    Shot shot;
};

// The bound: chords of 256 rings lie (pi / 256)^2 / 8 = 2e-5 inside the sphere, which the root of
// 0.1 makes 6e-5 of a normal; its 16 bits are 3e-5.
TEST_F(KeyLightAovTest, TheCosinesAreThoseOfTheSphere) {
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture) << base::to_line(picture.error());
    const Vec3 v(0.0F, 0.0F, 1.0F);
    const Vec3 l(shot.key_light.place);
    const Vec3 h = math::normalize(v + l);
    for (const Point& at : points()) {
        EXPECT_NEAR(value(*picture, "n_dot_v", at).x, at.normal.z, 5e-4F);
        EXPECT_NEAR(value(*picture, "n_dot_l", at).x, std::max(math::dot(at.normal, l), 0.0F),
                    5e-4F);
        EXPECT_NEAR(value(*picture, "n_dot_h", at).x, std::max(math::dot(at.normal, h), 0.0F),
                    5e-4F);
        EXPECT_NEAR(value(*picture, "v_dot_h", at).x, math::dot(v, h), 5e-4F);
    }
}

TEST_F(KeyLightAovTest, ALightWithAPlaceIsSeenFromEachPoint) {
    const Vec3 place(0.5F, 2.0F, 1.5F);
    shot.key_light.place = math::Vec4(place, 1.0F);
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture) << base::to_line(picture.error());
    for (const Point& at : points()) {
        const Vec3 l = math::normalize(place - at.normal);
        EXPECT_NEAR(value(*picture, "n_dot_l", at).x, std::max(math::dot(at.normal, l), 0.0F),
                    1e-3F);
    }
}

// Tolerances of shared/reference/README.md for float32 in a shader; far from the lobe Beckmann's D
// is below what a float holds.
TEST_F(KeyLightAovTest, DAndGAreTheTermsAtThePixelsCosines) {
    for (const char* text :
         {"distribution=ggx", "lecture", "distribution=beckmann,masking=smith"}) {
        shot.brdf = *brdf::parse_choice(text, brdf::Use::render);
        const auto picture = harness.draw(shot);
        ASSERT_TRUE(picture) << base::to_line(picture.error());
        brdf::Terms<double> terms{shot.brdf};
        const double r = static_cast<double>(roughness);
        for (const Point& at : points()) {
            const double n_h = static_cast<double>(value(*picture, "n_dot_h", at).x);
            const double n_l = static_cast<double>(value(*picture, "n_dot_l", at).x);
            const double n_v = static_cast<double>(value(*picture, "n_dot_v", at).x);
            const double d = terms.slot_distribution(n_h, r * r);
            const double g = 4.0 * n_v * n_l * terms.slot_masking(n_v, n_l, r, r * r);
            EXPECT_NEAR(static_cast<double>(value(*picture, "D", at).x), d, 2e-3 * d + 1e-30)
                << text;
            EXPECT_NEAR(static_cast<double>(value(*picture, "G", at).x), g, 2e-4 * g) << text;
        }
    }
}

// Schlick 1994, Eq. 15, with F0 mixed; the lecture's k_s is F and its k_d what F and metal leave.
TEST_F(KeyLightAovTest, TheLecturesSharesAreFresnelAndWhatItLeaves) {
    shot.brdf = *brdf::parse_choice("lecture", brdf::Use::render);
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture) << base::to_line(picture.error());
    const Vec3 f0 = Vec3(0.04F) * (1.0F - metallic) + base_color * metallic;
    for (const Point& at : points()) {
        const float x = 1.0F - value(*picture, "v_dot_h", at).x;
        const Vec3 f = f0 + (Vec3(1.0F) - f0) * (x * x * x * x * x);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(value(*picture, "F", at)[c], f[c], 2e-4F);
            EXPECT_NEAR(value(*picture, "ks", at)[c], f[c], 2e-4F);
            EXPECT_NEAR(value(*picture, "kd", at)[c], (1.0F - f[c]) * (1.0F - metallic), 2e-4F);
        }
    }
}

// Of the default model the terms are all there is: f = k_d albedo / pi
// + k_s D G / (4 n.v n.l). The picture's own light is 1 lux from the key light's direction.
TEST_F(KeyLightAovTest, TheTermsMakeUpWhatTheLightingPassShows) {
    shot.scene.lights = {{.direction = -Vec3(shot.key_light.place)}};
    const auto picture = harness.draw(shot);
    ASSERT_TRUE(picture) << base::to_line(picture.error());
    for (const Point& at : points()) {
        const float n_l = value(*picture, "n_dot_l", at).x;
        if (n_l < 0.02F) continue;
        const float d_v = value(*picture, "D", at).x * value(*picture, "G", at).x /
                          (4.0F * n_l * value(*picture, "n_dot_v", at).x);
        const Vec3 f =
            value(*picture, "kd", at) * base_color / math::pi + value(*picture, "ks", at) * d_v;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(f[c] * n_l, picture->at(at.x, at.y)[c], 1e-3F * (1.0F + f[c] * n_l));
    }
}

}  // namespace
}  // namespace facet::test
