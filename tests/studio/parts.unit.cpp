// Small parts of the studio: the view, scripts, what is read off pictures, texts.
// SPDX-License-Identifier: MIT
#include "base/resources.h"
#include "base/texts.h"
#include "scene/camera_spec.h"
#include "studio/actions.h"
#include "studio/analysis.h"
#include "studio/input.h"
#include "studio/orbit.h"
#include "studio/script.h"
#include "studio/texture_preview.h"
#include "support/temporary_folder.h"
#include "tables/aovs.h"
#include "tables/lights.h"
#include "tables/material.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace facet::studio {
namespace {

scene::Scene box() {
    scene::Scene scene;
    scene::Mesh mesh;
    mesh.positions_m = {{-1, -1, -1}, {1, 1, 1}, {1, -1, 1}};
    mesh.indices = {0, 1, 2};
    for (const math::Vec3& p : mesh.positions_m) mesh.bounds_m.add(p);
    scene.materials.emplace_back();
    scene.meshes.push_back(mesh);
    scene.instances.push_back({});
    return scene;
}

TEST(Orbit, TheCameraThatItsTextNamesLooksTheSameWay) {
    const scene::Scene scene = box();
    for (const Orbit& orbit : {Orbit{30.0F, 20.0F, 4.0F, {0.1F, 0.2F, 0.3F}},
                               Orbit{-170.0F, -60.0F, 0.5F, {0, 0, 0}}, Orbit{0.0F, 90.0F, 9.0F}}) {
        const auto camera = scene::resolve_camera(scene, camera_text(orbit), 0.0F, {64, 48});
        ASSERT_TRUE(camera) << base::to_line(camera.error());
        const Orbit again = orbit_of(*camera, scene.bounds_m());
        const math::Vec3 eye = orbit.target_m + orbit.back() * orbit.distance_m;
        const math::Vec3 eye_again = again.target_m + again.back() * again.distance_m;
        EXPECT_NEAR(math::length(eye - eye_again), 0.0F, 1e-4F);
        EXPECT_NEAR(math::dot(orbit.back(), again.back()), 1.0F, 1e-5F);
    }
}

TEST(Orbit, PanningMovesThePointUnderTheMouseWithIt) {
    Orbit orbit{0.0F, 0.0F, 2.0F, {0, 0, 0}};
    const float fov = 0.8F;
    pan(orbit, {10.0F, 0.0F}, 100.0F, fov);
    // The plane through the target is 2 * 2 tan(fov / 2) metres high over 100 pixels.
    EXPECT_NEAR(orbit.target_m.x, -10.0F * 4.0F * std::tan(0.5F * fov) / 100.0F, 1e-6F);
    EXPECT_NEAR(orbit.target_m.y, 0.0F, 1e-6F);
}

TEST(Orbit, FramingShowsEveryCorner) {
    math::Bounds bounds;
    bounds.add({1, 2, 3});
    bounds.add({4, 4, 5});
    Orbit orbit{40.0F, 30.0F, 1.0F, {0, 0, 0}};
    const float fov = 0.7F;
    frame(orbit, bounds, fov, 0.5F);
    for (unsigned corner = 0; corner < 8; ++corner) {
        const math::Vec3 at((corner & 1U) != 0 ? 1 : 4, (corner & 2U) != 0 ? 2 : 4,
                            (corner & 4U) != 0 ? 3 : 5);
        const math::Vec3 from_eye = at - (orbit.target_m + orbit.back() * orbit.distance_m);
        const float depth = -math::dot(from_eye, orbit.back());
        EXPECT_LT(std::fabs(math::dot(from_eye, orbit.up())), depth * std::tan(0.5F * fov));
        EXPECT_LT(std::fabs(math::dot(from_eye, orbit.right())),
                  0.5F * depth * std::tan(0.5F * fov));
    }
}

TEST(MouseQueue, ADragBetweenTwoFramesIsHeldWhereItBeganAndLetGoWhereItEnded) {
    const math::Vec2 start{10, 20};
    const math::Vec2 end{90, 20};
    const math::Vec2 now{5, 5};
    MouseQueue mouse;
    mouse.push(0, true, start);
    mouse.push(0, false, end);
    Input input;
    const auto frame = [&] {
        mouse.advance(input, now);
        return std::pair(input.mouse_px, input.buttons[0]);
    };
    EXPECT_EQ(frame(), std::pair(start, true));
    EXPECT_EQ(frame(), std::pair(end, true));
    EXPECT_EQ(frame(), std::pair(end, false));
    EXPECT_TRUE(mouse.is_empty());
    EXPECT_EQ(frame(), std::pair(now, false));
}

TEST(MouseQueue, TwoClicksAreTwo) {
    const math::Vec2 at{3, 4};
    MouseQueue mouse;
    for (const bool is_down : {true, false, true, false}) mouse.push(1, is_down, at);
    Input input;
    for (const bool is_down : {true, false, true, false}) {
        mouse.advance(input, at);
        EXPECT_EQ(input.buttons[1], is_down);
    }
    EXPECT_TRUE(mouse.is_empty());
}

TEST(Script, WordsInQuotesAreOneAndCommentsAreNone) {
    const auto steps =
        parse_script("# all\n set \"material.A b.roughness\" 0.4 # note\n\nundo\n", "s");
    ASSERT_TRUE(steps) << base::to_line(steps.error());
    ASSERT_EQ(steps->size(), 2U);
    EXPECT_EQ((*steps)[0].words, (std::vector<std::string>{"material.A b.roughness", "0.4"}));
    EXPECT_EQ((*steps)[1].verb, Verb::undo);
    EXPECT_EQ((*steps)[1].line, 4U);
}

TEST(Script, RefusalsNameTheLine) {
    for (const char* text : {"undo\nclik save\n", "undo\nclick\n", "undo\nset \"a 1\n"}) {
        const auto steps = parse_script(text, "s");
        ASSERT_FALSE(steps) << text;
        EXPECT_EQ(steps.error().where, "line 2") << text;
    }
}

TEST(Analysis, SharesOfAPictureWithoutItsBackground) {
    image::Image shown({4, 1}, 4, image::Sample::u8);
    const auto codes = shown.as<std::uint8_t>();
    const std::uint8_t pixels[4][4] = {
        {255, 10, 10, 255}, {0, 0, 0, 255}, {128, 128, 128, 255}, {255, 255, 255, 0}};
    for (std::size_t i = 0; i < 16; ++i) codes[i] = pixels[i / 4][i % 4];
    const Histogram h = histogram(shown);
    EXPECT_FLOAT_EQ(h.clipped_high, 1.0F / 3.0F);
    EXPECT_FLOAT_EQ(h.clipped_low, 1.0F / 3.0F);
    EXPECT_FLOAT_EQ(h.shares[0][63], 1.0F / 3.0F);
    EXPECT_FLOAT_EQ(h.shares[1][32], 1.0F / 3.0F);
}

TEST(TexturePreview, IsSmallAndShowsTheChannelAskedFor) {
    image::Image picture({600, 300}, 3, image::Sample::u8);
    const auto codes = picture.as<std::uint8_t>();
    for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = static_cast<std::uint8_t>(10 + i % 3);
    const image::Image green = preview(picture, Channel::green, 256);
    EXPECT_LE(green.size.width, 256U);
    EXPECT_EQ(green.size.width, 2 * green.size.height);
    for (const std::uint8_t code : green.as<std::uint8_t>()) ASSERT_EQ(code, 11);
}

/// Keys that the sources ask for by name.
std::set<std::string> asked_for() {
    std::set<std::string> keys;
    const std::filesystem::path room = FACET_SOURCE_DIR "/src/studio";
    for (const auto& file : std::filesystem::directory_iterator(room)) {
        const std::string text = support::text_of(file.path());
        for (std::size_t at = text.find("\"studio."); at != std::string::npos;
             at = text.find("\"studio.", at + 1)) {
            const std::string key = text.substr(at + 1, text.find('"', at + 1) - at - 1);
            if (!key.ends_with('.') && key != "studio.json" && key != "studio.NAME")
                keys.insert(key);
        }
    }
    for (const ActionRow& row : actions) keys.insert("studio." + std::string(row.name));
    for (const auto& row : tables::material_params) {
        keys.insert("param." + std::string(row.key));
        keys.insert("help." + std::string(row.key));
    }
    for (const auto& row : tables::material_textures) {
        keys.insert("param." + std::string(row.key));
        keys.insert("help." + std::string(row.key));
    }
    for (const auto& row : tables::light_keys) {
        keys.insert("light." + std::string(row.key));
        keys.insert("light.help." + std::string(row.key));
    }
    for (const auto& row : tables::light_kinds) keys.insert("light.kind." + std::string(row.key));
    for (const auto& row : tables::aovs) keys.insert("view." + std::string(row.key));
    return keys;
}

TEST(Texts, EveryKeyIsInEveryLanguageAndNoneIsInOneAlone) {
    std::map<std::string, nlohmann::json> texts;
    for (const std::string_view language : base::languages)
        texts[std::string(language)] = nlohmann::json::parse(support::text_of(
            *base::data_folder() / "resources/texts" / (std::string(language) + ".json")));
    for (const auto& [language, json] : texts) {
        for (const std::string& key : asked_for())
            EXPECT_TRUE(json.contains(key)) << language << " lacks " << key;
        for (const auto& [key, value] : texts["en"].items())
            EXPECT_TRUE(json.contains(key)) << language << " lacks " << key;
        for (const auto& [key, value] : json.items())
            EXPECT_TRUE(texts["en"].contains(key)) << "en lacks " << key;
    }
}

}  // namespace
}  // namespace facet::studio
