// facet teach and facet explain as they are typed.
// SPDX-License-Identifier: MIT
#include "support/process.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace facet::cli {
namespace {

namespace fs = std::filesystem;
using support::facet;
using support::Ran;
using support::TemporaryFolder;

void expect_refused(const Ran& ran, int exit, std::string_view word) {
    EXPECT_EQ(ran.exit, exit) << ran.err;
    EXPECT_EQ(support::line_count(ran.err), 1U) << ran.err;
    EXPECT_NE(ran.err.find(word), std::string::npos) << ran.err;
    EXPECT_EQ(ran.out, "");
}

TEST(Teach, MakesAPageAndKeepsWhatIsThere) {
    const TemporaryFolder folder;
    const auto teach = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "teach");
        return facet(words, {.folder = folder.path()});
    };
    EXPECT_EQ(teach({"distribution", "-o", "pages"}).exit, 0);
    const std::string page = support::text_of(folder.path() / "pages/distribution.html");
    EXPECT_NE(page.find("<math"), std::string::npos);
    EXPECT_EQ(page.find("src=\"http"), std::string::npos);
    EXPECT_TRUE(fs::exists(folder.path() / "pages/index.html"));
    expect_refused(teach({"fresnel", "-o", "pages"}), 2, "not empty");
    EXPECT_EQ(support::text_of(folder.path() / "pages/distribution.html"), page);
    EXPECT_FALSE(fs::exists(folder.path() / "pages/fresnel.html"));
    folder.write("pages/mine.txt", "kept");
    EXPECT_EQ(teach({"distribution", "-o", "pages", "--force", "--lang", "ru"}).exit, 0);
    EXPECT_EQ(support::text_of(folder.path() / "pages/mine.txt"), "kept");
    EXPECT_NE(support::text_of(folder.path() / "pages/distribution.html").find("lang=\"ru\""),
              std::string::npos);
}

TEST(Teach, TheSameLessonIsTheSamePage) {
    const TemporaryFolder folder;
    for (const char* threads : {"1", "2"})
        ASSERT_EQ(facet({"teach", "fresnel", "-o", threads, "--threads", threads},
                        {.folder = folder.path()})
                      .exit,
                  0);
    EXPECT_EQ(support::text_of(folder.path() / "1/fresnel.html"),
              support::text_of(folder.path() / "2/fresnel.html"));
}

TEST(Teach, ANewLessonIsTaughtAtOnce) {
    const TemporaryFolder folder;
    EXPECT_EQ(facet({"teach", "--new", "my-lesson"}, {.folder = folder.path()}).exit, 0);
    EXPECT_EQ(facet({"teach", "./my-lesson", "-o", "pages"}, {.folder = folder.path()}).exit, 0);
    EXPECT_TRUE(fs::exists(folder.path() / "pages/my-lesson.html"));
    expect_refused(facet({"teach", "--new", "my-lesson"}, {.folder = folder.path()}), 2, "already");
    expect_refused(facet({"teach", "--new", "My Lesson"}, {.folder = folder.path()}), 2,
                   "small letters");
    folder.write("my-lesson/lesson.json",
                 R"({"facet": 1, "strips": {"roughness": {"env": "nowhere.hdr"}}})");
    const Ran ran = facet({"teach", "./my-lesson", "-o", "other"}, {.folder = folder.path()});
    EXPECT_EQ(ran.exit, 3) << ran.err;
    EXPECT_NE(ran.err.find("/strips/roughness"), std::string::npos) << ran.err;
    EXPECT_FALSE(fs::exists(folder.path() / "other"));
}

TEST(Teach, RefusesInOneLine) {
    const TemporaryFolder folder;
    const auto refused = [&](std::vector<std::string> words, int exit, std::string_view word) {
        words.insert(words.begin(), "teach");
        expect_refused(facet(words, {.folder = folder.path()}), exit, word);
    };
    refused({"fresnell"}, 2, "did you mean fresnel");
    refused({"energy", "--lang", "de"}, 2, "en");
    refused({"energy", "-o", "no/folder"}, 2, "no such folder");
    refused({"energy", "energy"}, 2, "one name");
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(ExplainCommand, TellsAPixelAsATreeAndAsJson) {
    const Ran tree = facet({"explain", "builtin:ball", "--size", "64x64", "--pixel", "32,20",
                            "--light", "directional:name=key,lux=3"});
    EXPECT_EQ(tree.exit, 0) << tree.err;
    for (const char* word :
         {"material ball", "key (directional)", "n·l  n·h  v·h", "absorbed", "sum", "pbr-neutral"})
        EXPECT_NE(tree.out.find(word), std::string::npos) << word << "\n" << tree.out;
    const Ran both = facet({"explain", "builtin:ball", "--size", "64x64", "--pixel", "32,20",
                            "--pixel", "0,0", "--json"});
    EXPECT_EQ(both.exit, 0) << both.err;
    EXPECT_EQ(support::line_count(both.out), 2U);
    const auto first = nlohmann::json::parse(both.out.substr(0, both.out.find('\n')));
    EXPECT_EQ(first["sum"].size(), 3U);
    EXPECT_NE(
        facet({"explain", "builtin:ball", "--size", "64x64", "--pixel", "0,0", "--lang", "ru"})
            .out.find("фон"),
        std::string::npos);
}

TEST(ExplainCommand, RefusesInOneLine) {
    const auto refused = [&](std::vector<std::string> words, std::string_view word) {
        words.insert(words.begin(), {"explain", "builtin:ball", "--size", "64x64"});
        expect_refused(facet(words), 2, word);
    };
    refused({}, "which pixel");
    refused({"--pixel", "64,0"}, "0 to 63");
    refused({"--pixel", "-1,0"}, "outside");
    refused({"--pixel", "a,b"}, "X,Y");
    refused({"--pixel", "1,1", "--reference", "4"}, "--reference");
    refused({"--pixel", "1,1", "--aov", "D"}, "--aov");
    refused({"--pixel", "1,1", "--lang", "de"}, "en");
}

}  // namespace
}  // namespace facet::cli
