// facet batch of files with animations, as it is typed.
// SPDX-License-Identifier: MIT
#include "scene/animation_fixture.h"
#include "support/process.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace facet::cli {
namespace {

namespace fs = std::filesystem;
using support::facet;
using support::Ran;
using support::TemporaryFolder;
using support::text_of;

Ran batch_animated(const TemporaryFolder& folder, std::vector<std::string> words) {
    words.insert(words.begin(), "batch");
    return facet(words, {.folder = folder.path()});
}

// Frames share one scene that moves on; each is the picture that the scene gives at its time alone.
TEST(AnimatedBatch, FramesOfAnAnimationAreThoseOfRender) {
    const TemporaryFolder folder;
    test::Document d = test::skinned();
    d.json["animations"][0]["name"] = "Bend";
    folder.write("a.gltf", d.text());
    folder.write("job.json", R"({"facet": 1, "output": "{frame}.png",
        "defaults": {"size": "48x32", "quality": "draft", "exposure": 1, "shutter": 0.1},
        "items": [{"scene": "a.gltf", "frames": {"animation": "Bend", "fps": 4}}]})");
    const auto ran = batch_animated(folder, {"job.json", "--jobs", "1", "--report", "sheet.html"});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_NE(text_of(folder / "sheet.html").find("ffmpeg -framerate 4 "), std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "4.png"));
    for (const char* const frame : {"0", "3"}) {
        const std::string time = std::string(frame) == "0" ? "0" : "0.75";
        const auto alone =
            facet({"render", "a.gltf", "--size", "48x32", "--quality", "draft", "--exposure", "1",
                   "--shutter", "0.1", "--animation", "Bend", "--time", time, "-o", "alone.png"},
                  {.folder = folder.path()});
        EXPECT_EQ(alone.exit, 0) << alone.err;
        EXPECT_EQ(text_of(folder / "alone.png"), text_of(folder / (std::string(frame) + ".png")))
            << frame;
    }
}

// What an item asks for and does not get is not there for the next one either.
TEST(AnimatedBatch, AnAnimationThatIsNotThereFailsItsItemAlone) {
    const TemporaryFolder folder;
    folder.write("a.gltf", test::skinned().text());
    folder.write("job.json", R"({"facet": 1, "output": "{index}.png",
        "defaults": {"size": "48x32", "quality": "draft", "exposure": 1, "time": 1},
        "items": [{"scene": "a.gltf", "animation": ["0", "Nope", "0"], "env": ["studio", "sky"]}]})");
    const Ran ran = batch_animated(folder, {"job.json", "--jobs", "1"});
    EXPECT_EQ(ran.exit, 1) << ran.err;
    EXPECT_NE(ran.err.find("no such animation (Nope)"), std::string::npos) << ran.err;
    EXPECT_FALSE(fs::exists(folder / "2.png"));
    EXPECT_EQ(text_of(folder / "0.png"), text_of(folder / "4.png"));
    EXPECT_EQ(text_of(folder / "1.png"), text_of(folder / "5.png"));
}

// The samples of a blurred picture leave the scene at the last one's time; the next camera stands
// where its node is in the middle.
TEST(AnimatedBatch, ACameraAfterABlurredPictureIsThatOfRender) {
    const TemporaryFolder folder;
    test::Document d = test::triangle();
    d.json["cameras"] = {{{"type", "perspective"},
                          {"perspective", {{"yfov", 0.8}, {"znear", 0.1}, {"zfar", 20.0}}}}};
    d.json["nodes"] = {{{"mesh", 0}}, {{"camera", 0}}};
    d.json["scenes"][0]["nodes"] = {0, 1};
    test::animate(d, 0, 1, "translation", test::times(d, {0, 2}),
                  d.floats("VEC3", 3, {0, 0, 3, 1, 0, 2}));
    folder.write("a.gltf", d.text());
    folder.write("job.json", R"({"facet": 1, "output": "{index}.png",
        "defaults": {"size": "48x32", "quality": "draft", "exposure": 1, "time": 1, "shutter": 0.8},
        "items": [{"scene": "a.gltf", "camera": ["auto", "0"]}]})");
    const Ran ran = batch_animated(folder, {"job.json", "--jobs", "1"});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    const Ran alone =
        facet({"render", "a.gltf", "--size", "48x32", "--quality", "draft", "--exposure", "1",
               "--time", "1", "--shutter", "0.8", "--camera", "0", "-o", "alone.png"},
              {.folder = folder.path()});
    EXPECT_EQ(alone.exit, 0) << alone.err;
    EXPECT_EQ(text_of(folder / "alone.png"), text_of(folder / "1.png"));
}

}  // namespace
}  // namespace facet::cli
