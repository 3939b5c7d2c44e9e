// facet render: the picture, the line about it, and what is left on disk when it cannot be made.
// SPDX-License-Identifier: MIT
#include "scene/animation_fixture.h"
#include "support/process.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

namespace facet::cli {
namespace {

namespace fs = std::filesystem;
using support::facet;
using support::line_count;
using support::Ran;
using support::TemporaryFolder;
using support::text_of;

constexpr std::string_view png_magic = "\x89PNG\r\n\x1a\n";
const std::vector<std::string> quick = {"render", "builtin:furnace", "--size",
                                        "32x16",  "--quality",       "draft"};

std::vector<std::string> with(std::vector<std::string> more) {
    more.insert(more.begin(), quick.begin(), quick.end());
    return more;
}

TEST(Render, PrintsThePathTheSizeAndTheTime) {
    const TemporaryFolder folder;
    const Ran ran = facet(with({"-o", (folder / "a.png").string()}));
    ASSERT_EQ(ran.exit, 0) << ran.err;
    EXPECT_TRUE(ran.out.starts_with((folder / "a.png").string() + "  32x16  ")) << ran.out;
    EXPECT_TRUE(ran.out.ends_with(" s\n")) << ran.out;
    EXPECT_TRUE(text_of(folder / "a.png").starts_with(png_magic));
    EXPECT_EQ(folder.entry_count(), 1);
}
TEST(Render, WithoutAnOutputWritesTheScenesNameIntoTheCurrentFolder) {
    const TemporaryFolder folder;
    const Ran ran = facet(quick, {.folder = folder.path()});
    ASSERT_EQ(ran.exit, 0) << ran.err;
    EXPECT_TRUE(fs::exists(folder / "furnace.png"));
}
TEST(Render, WithJsonPrintsOneObjectWithTheContractsKeys) {
    const TemporaryFolder folder;
    const Ran ran = facet(with({"-o", (folder / "a.png").string(), "--json"}));
    ASSERT_EQ(ran.exit, 0) << ran.err;
    EXPECT_EQ(line_count(ran.out), 1U);
    const auto object = nlohmann::json::parse(ran.out);
    EXPECT_EQ(object["facet"], 1);
    EXPECT_EQ(object["output"], (folder / "a.png").string());
    EXPECT_EQ(object["width"], 32);
    EXPECT_EQ(object["height"], 16);
    for (const char* key : {"exposure", "ms", "backend", "triangles", "materials", "warnings"})
        EXPECT_TRUE(object.contains(key)) << key;
    for (const char* key : {"load", "upload", "render", "write"})
        EXPECT_TRUE(object["ms"].contains(key)) << key;
}
TEST(Render, AnAnimationThatIsNotThereOrBrokenIsOneClearLine) {
    const TemporaryFolder folder;
    test::Document d = test::moving();
    d.json["animations"][0]["name"] = "Walk";
    test::animate(d, 1, 0, "translation", test::times(d, {1, 0}),
                  d.floats("VEC3", 3, {0, 0, 0, 0, 9, 0}));
    folder.write("a.gltf", d.text());
    const auto play = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"render", "a.gltf", "--size", "16x16", "--quality", "draft"});
        return facet(more, {.folder = folder.path()});
    };
    EXPECT_EQ(play({"--animation", "Walk", "--time", "0.5"}).exit, 0);
    const Ran unknown = play({"--animation", "Wlak"});
    EXPECT_EQ(unknown.exit, 2);
    EXPECT_NE(unknown.err.find("--animation: the file has no such animation (Wlak); one of Walk, "
                               "animation 1, or its index, 0 to 1"),
              std::string::npos)
        << unknown.err;
    const Ran broken = play({"--animation", "1"});
    EXPECT_EQ(broken.exit, 3);
    EXPECT_NE(broken.err.find("a.gltf:/animations/1/samplers/0/input: times do not increase"),
              std::string::npos)
        << broken.err;
    const Ran unplayed = play({});
    EXPECT_EQ(unplayed.exit, 0);
    EXPECT_NE(unplayed.err.find("times do not increase"), std::string::npos) << unplayed.err;
    const Ran still = facet(with({"--time", "1", "-o", (folder / "b.png").string()}));
    EXPECT_EQ(still.exit, 0);
    EXPECT_NE(still.err.find("the file has no animation"), std::string::npos) << still.err;
}
TEST(Render, ToStandardOutputIsAPngAndNothingElse) {
    const Ran ran = facet(with({"-o", "-"}));
    ASSERT_EQ(ran.exit, 0) << ran.err;
    EXPECT_TRUE(ran.out.starts_with(png_magic));
    EXPECT_EQ(ran.out.substr(ran.out.size() - 8, 4), "IEND");
}
// What a file's plan sets holds for standard output too: gamut, depth, metadata, --strict.
TEST(Render, ToStandardOutputHasTheBytesOfAFile) {
    const TemporaryFolder folder;
    const std::string file = (folder / "a.png").string();
    for (const char* const gamut : {"srgb", "p3", "rec2020-pq"}) {
        const Ran written = facet(with({"-o", file, "--gamut", gamut}));
        const Ran piped = facet(with({"-o", "-", "--gamut", gamut}));
        ASSERT_EQ(written.exit, 0) << written.err;
        EXPECT_EQ(piped.out, text_of(file)) << gamut;
    }
    EXPECT_EQ(facet(with({"-o", "-", "--depth", "half"})).exit, 2);
    const std::vector<std::string> strict = {"--strict",  "--set", "material.ball.roughness=0.5",
                                             "--shadows", "maps",  "--ground",
                                             "shadow"};
    auto to = [&](const std::string& output) {
        auto words = strict;
        words.insert(words.end(), {"-o", output});
        return facet(with(words)).exit;
    };
    EXPECT_EQ(to("-"), to(file));
}
TEST(Render, GivesTheSameBytesForAnyNumberOfThreadsAndAnyLocale) {
    const Ran one = facet(with({"-o", "-", "--threads", "1"}));
    const Ran two = facet(with({"-o", "-", "--threads", "3"}),
                          {.environment = {"LC_ALL=de_DE.UTF-8", "TZ=nonsense"}});
    ASSERT_EQ(one.exit, 0) << one.err;
    EXPECT_EQ(one.out, two.out);
}
TEST(Render, WorksWithoutDisplayAndHome) {
    const TemporaryFolder folder;
    std::vector<std::string> words{"/usr/bin/env", "-i", FACET_BINARY_DIR "/facet"};
    const auto arguments = with({"-o", (folder / "a.png").string()});
    words.insert(words.end(), arguments.begin(), arguments.end());
    const Ran ran = support::run(words);
    EXPECT_EQ(ran.exit, 0) << ran.err;
}
TEST(Render, TakesNamesWithSpacesQuotesNewlinesAndLeadingDashes) {
    const TemporaryFolder folder;
    for (const char* name :
         {"a b.png", "it's.png", "-dash.png", "two\nlines.png", "\xff.png", "шлем.png"}) {
        const Ran ran = facet(with({"-o", name}), {.folder = folder.path()});
        EXPECT_EQ(ran.exit, 0) << name << ran.err;
        EXPECT_TRUE(fs::exists(folder / name)) << name;
        EXPECT_EQ(line_count(ran.out), 1U) << ran.out;
    }
}

/// An output that is refused: nothing new on disk, the old file untouched.
struct Refused : testing::Test {
    TemporaryFolder folder;
    Ran render(const std::string& output, std::vector<std::string> more = {}) {
        more.insert(more.begin(), {"-o", output});
        return facet(with(more), {.folder = folder.path()});
    }
};
TEST_F(Refused, AMissingFolderIsUsageAndMkdirsMakesIt) {
    const Ran ran = render("no/a.png");
    EXPECT_EQ(ran.exit, 2);
    EXPECT_EQ(ran.err, "facet: no/a.png: no such folder (no); make it, or give --mkdirs\n");
    EXPECT_EQ(folder.entry_count(), 0);
    EXPECT_EQ(render("no/deeper/a.png", {"--mkdirs"}).exit, 0);
    EXPECT_TRUE(fs::exists(folder / "no/deeper/a.png"));
}
TEST_F(Refused, AFolderAsOutputIsInvalid) {
    fs::create_directory(folder / "a.png");
    EXPECT_EQ(render("a.png").exit, 3);
}
TEST_F(Refused, AnExistingFileStaysWithNoClobber) {
    folder.write("a.png", "old");
    EXPECT_EQ(render("a.png", {"--no-clobber"}).exit, 2);
    EXPECT_EQ(text_of(folder / "a.png"), "old");
    EXPECT_EQ(render("a.png").exit, 0);
    EXPECT_TRUE(text_of(folder / "a.png").starts_with(png_magic));
}
TEST_F(Refused, AnEndingThatNoFormatHasListsThoseThereAre) {
    const Ran ran = render("a.bmp");
    EXPECT_EQ(ran.exit, 2);
    EXPECT_NE(ran.err.find("endings: .png"), std::string::npos) << ran.err;
    EXPECT_EQ(folder.entry_count(), 0);
}
TEST_F(Refused, ALinkThatLeavesTheFolderIsNotFollowed) {
    folder.write("other/a.png", "old");
    fs::create_directory(folder / "in");
    fs::create_symlink("../other/a.png", folder / "in/a.png");
    EXPECT_EQ(render("in/a.png").exit, 3);
    EXPECT_EQ(text_of(folder / "other/a.png"), "old");
}
TEST_F(Refused, ANameThatIsTooLongSaysSo) {
    const Ran ran = render(std::string(260, 'n') + ".png");
    EXPECT_EQ(ran.exit, 3);
    EXPECT_NE(ran.err.find("name too long (264 bytes)"), std::string::npos) << ran.err;
}
TEST_F(Refused, AnInputIsNeverTheOutputNotEvenThroughALink) {
    folder.write("env.hdr", "#?RADIANCE\n");
    fs::create_hard_link(folder / "env.hdr", folder / "out.hdr");
    const Ran ran = render("out.hdr", {"--env", "env.hdr"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_NE(ran.err.find("is an input too"), std::string::npos) << ran.err;
    EXPECT_EQ(text_of(folder / "env.hdr"), "#?RADIANCE\n");
}
TEST_F(Refused, AFileSizeLimitLeavesTheOldFile) {
    folder.write("a.png", "old");
    const Ran ran =
        facet(with({"-o", "a.png"}), {.folder = folder.path(), .before = "ulimit -f 0"});
    EXPECT_EQ(ran.exit, 75) << ran.err;
    EXPECT_EQ(text_of(folder / "a.png"), "old");
    EXPECT_EQ(folder.entry_count(), 1);
}

TEST(RenderInput, ThatIsMissingOrNoSceneIsInvalidAndWritesNothing) {
    const TemporaryFolder folder;
    folder.write("page.glb", "<!DOCTYPE html><html>");
    folder.write("empty.gltf", "");
    ASSERT_EQ(::mkfifo((folder / "fifo.glb").c_str(), 0600), 0);
    for (const char* scene :
         {"missing.glb", "page.glb", "empty.gltf", "fifo.glb", "/dev/zero", "."}) {
        const Ran ran = facet({"render", scene, "-o", "out.png"}, {.folder = folder.path()});
        EXPECT_EQ(ran.exit, 3) << scene << ": " << ran.err;
        EXPECT_EQ(line_count(ran.err), 1U) << ran.err;
        EXPECT_TRUE(ran.err.starts_with("facet: " + std::string(scene))) << ran.err;
        EXPECT_FALSE(fs::exists(folder / "out.png")) << scene;
    }
}
TEST(RenderInput, ABuiltInSceneThatIsMisspeltIsAnsweredWithTheRightOne) {
    const Ran ran = facet({"render", "builtin:showcas", "-o", "/nowhere/a.png"});
    EXPECT_NE(ran.exit, 0);
    const TemporaryFolder folder;
    const Ran named = facet({"render", "builtin:showcas"}, {.folder = folder.path()});
    EXPECT_NE(named.err.find("showcase"), std::string::npos) << named.err;
    EXPECT_EQ(folder.entry_count(), 0);
}
TEST(RenderInput, OnStandardInputIsRead) {
    const TemporaryFolder folder;
    const Ran ran =
        facet({"render", "-", "-o", "out.png"}, {.folder = folder.path(), .input = "not a model"});
    EXPECT_EQ(ran.exit, 3) << ran.err;
    EXPECT_EQ(folder.entry_count(), 0);
}

}  // namespace
}  // namespace facet::cli
