// The built program's studio without a display, worked by scripts as a person would work it.
// SPDX-License-Identifier: MIT
#include "scene/animation_fixture.h"
#include "studio/run_script.h"
#include "support/picture.h"
#include "support/process.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace facet::studio {
namespace {

using support::facet;
using support::picture;
using support::Ran;
using support::TemporaryFolder;
using support::text_of;

/// A window small enough for a test; panels keep their widths, so the viewport is the middle of it.
constexpr std::uint32_t window_width = 960;
constexpr std::uint32_t window_height = 640;

Ran studio(const TemporaryFolder& folder, const std::string& script,
           std::vector<std::string> more = {}, const std::string& scene = "builtin:furnace") {
    std::vector<std::string> all{"--env", "studio", "--samples", "2", "--exposure", "1"};
    all.insert(all.end(), more.begin(), more.end());
    return test::run_script(folder, scene, "960x640", script, all);
}

/// Share of the pixels within the box (shares of the window) that differ by more than `codes`.
double changed(const image::Image& a, const image::Image& b, double x0, double y0, double x1,
               double y1, int codes = 8) {
    if (a.size != b.size || a.bytes.empty() || a.channels != b.channels) return -1.0;
    const auto p = a.as<std::uint8_t>();
    const auto q = b.as<std::uint8_t>();
    std::size_t count = 0;
    std::size_t different = 0;
    const auto at = [](double share, std::uint32_t side) {
        return static_cast<std::size_t>(share * side);
    };
    for (std::size_t y = at(y0, a.size.height); y < at(y1, a.size.height); ++y)
        for (std::size_t x = at(x0, a.size.width); x < at(x1, a.size.width); ++x) {
            ++count;
            const std::size_t first = (y * a.size.width + x) * a.channels;
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c)
                most = std::max(most, std::abs(int{p[first + c]} - int{q[first + c]}));
            different += most > codes ? 1U : 0U;
        }
    return static_cast<double>(different) / static_cast<double>(count);
}

TEST(Studio, ASliderChangesThePictureAndUndoPutsItBackToTheByte) {
    const TemporaryFolder folder;
    // The mouse rests at the same place for both pictures that have to be equal.
    const Ran ran = studio(folder, R"(
click node[2]
drag roughness 0.5
undo
click histogram
wait
shot before.png
drag roughness 0.9
click histogram
wait
shot after.png
undo
click histogram
wait
shot undone.png
redo
click histogram
wait
shot redone.png
)");
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const image::Image before = picture(folder / "before.png");
    const image::Image after = picture(folder / "after.png");
    EXPECT_EQ(before.size, (math::Extent{window_width, window_height}));
    // The ball of that material, and those on its right.
    EXPECT_GT(changed(before, after, 0.37, 0.13, 0.455, 0.26), 0.1);
    // Only what mirrors it a little changes with it.
    EXPECT_LT(changed(before, after, 0.47, 0.10, 0.62, 0.50), 0.02);
    EXPECT_TRUE(text_of(folder / "before.png") == text_of(folder / "undone.png"));
    EXPECT_TRUE(text_of(folder / "after.png") == text_of(folder / "redone.png"));
}

TEST(Studio, WhatIsSavedOpensAgainToTheSameWindow) {
    const TemporaryFolder folder;
    const Ran first = studio(folder, R"(
drag roughness 0.35
click histogram
wait
save edited.glb
save material.json
save picture.png
wait
)",
                             {"--size", "160x90"});
    ASSERT_EQ(first.exit, 0) << first.err;
    EXPECT_NE(text_of(folder / "material.json").find("\"roughness\": 0.3"), std::string::npos);
    // The picture is what the command says, to the byte.
    const Ran rendered = facet({"render", "edited.glb", "-o", "again.png", "--size", "160x90",
                                "--env", "studio", "--samples", "2", "--exposure", "1"},
                               {.folder = folder.path()});
    ASSERT_EQ(rendered.exit, 0) << rendered.err;
    EXPECT_TRUE(text_of(folder / "picture.png") == text_of(folder / "again.png"));
    const Ran second = studio(folder, "wait\nsave twice.glb\n", {}, "edited.glb");
    ASSERT_EQ(second.exit, 0) << second.err;
    EXPECT_TRUE(text_of(folder / "twice.glb") == text_of(folder / "edited.glb"));
}

TEST(Studio, TheSameScriptGivesTheSameBytes) {
    const std::string script =
        "drag metallic 0.4\nclick view\nclick view.normal\nwait\nshot a.png\n";
    const TemporaryFolder one;
    const TemporaryFolder two;
    ASSERT_EQ(studio(one, script).exit, 0);
    ASSERT_EQ(studio(two, script, {"--threads", "1"}).exit, 0);
    EXPECT_TRUE(text_of(one / "a.png") == text_of(two / "a.png"));
}

TEST(Studio, EveryViewDrawsAndTurningTheViewMovesThePicture) {
    const TemporaryFolder folder;
    const Ran ran = studio(folder, R"(
wait
shot beauty.png
key v
wait
shot second.png
click view
click view.roughness
wait
shot roughness.png
drag viewport 80 20
wait
shot turned.png
)");
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const auto middle = [&](const char* a, const char* b) {
        return changed(picture(folder / a), picture(folder / b), 0.3, 0.1, 0.6, 0.6);
    };
    EXPECT_GT(middle("beauty.png", "roughness.png"), 0.1);
    EXPECT_GT(middle("roughness.png", "turned.png"), 0.02);
}

TEST(Studio, SpeaksBothLanguagesInBothThemes) {
    const TemporaryFolder folder;
    for (const char* language : {"en", "ru"})
        for (const char* theme : {"dark", "light"}) {
            const std::string shot = std::string(language) + theme + ".png";
            const Ran ran = facet({"studio", "builtin:furnace", "--offscreen", "--window",
                                   "640x400", "--frames", "4", "--shot", (folder / shot).string(),
                                   "--lang", language, "--theme", theme});
            ASSERT_EQ(ran.exit, 0) << ran.err;
        }
    EXPECT_NE(text_of(folder / "endark.png"), text_of(folder / "rudark.png"));
    EXPECT_NE(text_of(folder / "endark.png"), text_of(folder / "enlight.png"));
}

TEST(Studio, OpensALessonAndGoesToItsViews) {
    const TemporaryFolder folder;
    folder.write("script.txt",
                 "wait\nshot a.png\nclick lesson.view[5]\nwait\nshot b.png\nundo\nquit\n");
    for (const char* language : {"en", "ru"}) {
        const Ran ran = facet({"studio", "--offscreen", "--lesson", "geometry", "--lang", language,
                               "--window", "960x640", "--do", "script.txt"},
                              {.folder = folder.path()});
        ASSERT_EQ(ran.exit, 0) << ran.err;
        const double share = changed(picture(folder.path() / "a.png"),
                                     picture(folder.path() / "b.png"), 0.3, 0.1, 0.7, 0.6);
        EXPECT_GT(share, 0.05) << "the view shows G, the picture before it light";
    }
}

/// A triangle that fills the view and goes away in a second.
std::string film() {
    test::Document d = test::triangle();
    d.json["materials"] = {{{"doubleSided", true}}};
    test::primitive(d)["material"] = 0;
    test::animate(d, 0, 0, "translation", test::times(d, {0, 1}),
                  d.floats("VEC3", 3, {0, 0, 0, 9, 0, 0}));
    d.json["animations"][0]["name"] = "Leave";
    return d.text();
}

TEST(Studio, AnAnimationIsChosenScrubbedAndPlayed) {
    const TemporaryFolder folder;
    folder.write("film.gltf", film());
    const std::vector<std::string> front{"--camera", "orbit:azimuth=0,elevation=0,distance=3"};
    const Ran ran = studio(folder, R"(
click histogram
wait
shot still.png
click animation
click animation.Leave
click histogram
wait
shot first.png
drag time 0.9
click histogram
wait
shot away.png
undo
click histogram
wait
shot undone.png
click play
wait 20
click pause
click histogram
wait
shot played.png
)",
                           front, "film.gltf");
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const image::Image still = picture(folder / "still.png");
    const image::Image first = picture(folder / "first.png");
    const auto difference = [&](const char* name) {
        return changed(first, picture(folder / name), 0.35, 0.15, 0.65, 0.6);
    };
    EXPECT_EQ(changed(first, still, 0.35, 0.15, 0.65, 0.6), 0.0);
    EXPECT_GT(difference("away.png"), 0.1);
    EXPECT_EQ(difference("undone.png"), 0.0);
    EXPECT_GT(difference("played.png"), 0.05);
}

TEST(Studio, AVariantIsChosenAndUndone) {
    const TemporaryFolder folder;
    test::Document d = test::triangle();
    d.json["extensionsUsed"] = {"KHR_materials_variants"};
    d.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "green"}}};
    d.json["materials"] = {
        {{"name", "red"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}},
        {{"name", "green"}, {"pbrMetallicRoughness", {{"baseColorFactor", {0, 1, 0, 1}}}}}};
    test::primitive(d)["material"] = 0;
    test::primitive(d)["extensions"]["KHR_materials_variants"]["mappings"] = {
        {{"material", 1}, {"variants", {0}}}};
    folder.write("shoe.gltf", d.text());
    const Ran ran = studio(folder, R"(
click histogram
wait
shot red.png
click variant
click variant.green
click histogram
wait
shot green.png
undo
click histogram
wait
shot undone.png
)",
                           {"--camera", "orbit:azimuth=0,elevation=0,distance=3"}, "shoe.gltf");
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const image::Image red = picture(folder / "red.png");
    EXPECT_GT(changed(red, picture(folder / "green.png"), 0.35, 0.15, 0.65, 0.6), 0.1);
    EXPECT_EQ(changed(red, picture(folder / "undone.png"), 0.35, 0.15, 0.65, 0.6), 0.0);
}

TEST(Studio, RefusesWhatCannotWorkInOneLine) {
    const TemporaryFolder folder;
    const auto refused = [&](std::vector<std::string> arguments, int exit, std::string_view word) {
        arguments.insert(arguments.begin(), "studio");
        const Ran ran = facet(
            arguments, {.environment = {"DISPLAY=", "WAYLAND_DISPLAY="}, .folder = folder.path()});
        EXPECT_EQ(ran.exit, exit) << ran.err;
        EXPECT_EQ(support::line_count(ran.err), 1U) << ran.err;
        EXPECT_NE(ran.err.find(word), std::string::npos) << ran.err;
    };
    folder.write("bad.txt", "undo\nclik save\n");
    folder.write("lost.txt", "click no_such_widget\n");
    folder.write("set.txt", "set material.gold.rougness 0.3\n");
    refused({"builtin:furnace"}, 6, "--offscreen");
    refused({"builtin:furnace", "--offscreen"}, 2, "--frames");
    refused({"builtin:furnace", "--offscreen", "--do", "bad.txt"}, 2, "line 2");
    refused({"builtin:furnace", "--offscreen", "--do", "lost.txt"}, 2, "no_such_widget");
    refused({"builtin:furnace", "--offscreen", "--do", "set.txt"}, 2, "gold");
    folder.write("value.txt", "set background pink\nwait\n");
    refused({"builtin:furnace", "--offscreen", "--do", "value.txt"}, 2, "--background");
    refused({"--offscreen", "--frames", "1", "--lesson", "fresnell"}, 2, "fresnel");
    refused({"builtin:ball", "--offscreen", "--frames", "1", "--lesson", "fresnel"}, 2, "--lesson");
    refused({"no-such.glb", "--offscreen", "--frames", "1"}, 3, "no-such.glb");
    refused({"builtin:furnace", "--offscreen", "--frames", "1", "--lang", "de"}, 2, "en");
    refused({"builtin:furnace", "--offscreen", "--frames", "1", "--theme", "pink"}, 2, "dark");
    refused({"builtin:furnace", "--offscreen", "--frames", "1", "--window", "3x3"}, 2, "--window");
    refused({"builtin:furnace", "--offscreen", "--frames", "1", "--shot", "no/folder.png"}, 2,
            "no/folder.png");
}

TEST(Studio, ASaveThatFailsEndsAScriptAndWritesNothing) {
    const TemporaryFolder folder;
    const Ran ran = studio(folder, "drag roughness 0.5\nsave no/such/folder.glb\n");
    EXPECT_EQ(ran.exit, 2);
    EXPECT_NE(ran.err.find("no/such"), std::string::npos) << ran.err;
    EXPECT_EQ(folder.entry_count(), 1) << "the script, and nothing else";
}

}  // namespace
}  // namespace facet::studio
