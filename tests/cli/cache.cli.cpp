// The cache folder: never in the way, and never in the picture.
// SPDX-License-Identifier: MIT
#include "support/process.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include <future>

namespace facet::cli {
namespace {

namespace fs = std::filesystem;
using support::facet;
using support::Ran;
using support::TemporaryFolder;
using support::text_of;

/// A picture that the environment lights, in a format and with a cache folder.
Ran drawn(const TemporaryFolder& folder, const std::string& output, const std::string& cache,
          std::vector<std::string> environment = {}) {
    environment.push_back("XDG_CACHE_HOME=" + cache);
    return facet(support::draft_render("builtin:ball", (folder / output).string(),
                                       {"--env", "overcast", "--env-rotation", "20"}),
                 {.environment = environment});
}

TEST(Cache, ChangesNoByteOfAPicture) {
    const TemporaryFolder folder;
    const std::string cache = (folder / "cache").string();
    for (const std::string ending : {".png", ".exr"}) {
        ASSERT_EQ(drawn(folder, "off" + ending, cache, {"FACET_CACHE=off"}).exit, 0);
        EXPECT_FALSE(fs::exists(folder / "cache/facet/environments"));
        ASSERT_EQ(drawn(folder, "first" + ending, cache).exit, 0);
        EXPECT_TRUE(fs::exists(folder / "cache/facet/environments"));
        ASSERT_EQ(drawn(folder, "second" + ending, cache).exit, 0);
        const std::string off = text_of(folder / ("off" + ending));
        EXPECT_FALSE(off.empty());
        EXPECT_TRUE(text_of(folder / ("first" + ending)) == off) << ending;
        EXPECT_TRUE(text_of(folder / ("second" + ending)) == off) << ending;
        fs::remove_all(folder / "cache");
    }
}

TEST(Cache, ThatIsBentIsMadeAnew) {
    const TemporaryFolder folder;
    const std::string cache = (folder / "cache").string();
    ASSERT_EQ(drawn(folder, "a.png", cache).exit, 0);
    const fs::path file = fs::directory_iterator(folder / "cache/facet/environments")->path();
    const std::string whole = text_of(file);
    for (const std::string& text : {std::string("x"), whole.substr(0, whole.size() - 7)}) {
        std::ofstream(file, std::ios::binary) << text;
        const Ran ran = drawn(folder, "b.png", cache);
        ASSERT_EQ(ran.exit, 0) << ran.err;
        EXPECT_TRUE(text_of(folder / "b.png") == text_of(folder / "a.png"));
        EXPECT_TRUE(text_of(file) == whole);
    }
}

TEST(Cache, ThatCannotBeUsedIsOneWarningAndThePicture) {
    const TemporaryFolder folder;
    ASSERT_EQ(drawn(folder, "a.png", (folder / "cache").string()).exit, 0);
    folder.write("file", "");
    ASSERT_EQ(::chmod((folder / "cache/facet/environments").c_str(), 0777), 0);
    for (const std::string& cache : {(folder / "file").string(), (folder / "cache").string()}) {
        const Ran ran = drawn(folder, "b.png", cache);
        EXPECT_EQ(ran.exit, 0) << ran.err;
        EXPECT_EQ(support::line_count(ran.err), 1U) << ran.err;
        EXPECT_NE(ran.err.find("FACET_CACHE=off"), std::string::npos) << ran.err;
        EXPECT_TRUE(text_of(folder / "b.png") == text_of(folder / "a.png"));
    }
    // The picture is what was asked for, and to --strict too.
    const Ran strict = facet(support::draft_render("builtin:ball", (folder / "c.png").string(),
                                                   {"--env", "overcast", "--strict"}),
                             {.environment = {"XDG_CACHE_HOME=" + (folder / "file").string()}});
    EXPECT_EQ(strict.exit, 0) << strict.err;
}

TEST(Cache, WithoutAHomeIsOneWarning) {
    const TemporaryFolder folder;
    for (const std::string home : {"", "not/absolute"}) {
        const Ran ran = drawn(folder, "a.png", "", {"HOME=" + home});
        EXPECT_EQ(ran.exit, 0) << ran.err;
        EXPECT_EQ(support::line_count(ran.err), 1U) << ran.err;
        EXPECT_NE(ran.err.find("no folder for caches"), std::string::npos) << ran.err;
        const Ran off = drawn(folder, "a.png", "", {"HOME=" + home, "FACET_CACHE=off"});
        EXPECT_EQ(off.err, "");
    }
}

TEST(Cache, VariableIsOnOrOff) {
    const Ran ran = facet({"doctor"}, {.environment = {"FACET_CACHE=of"}});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_NE(ran.err.find("FACET_CACHE"), std::string::npos) << ran.err;
}

TEST(Cache, IsSharedByProcesses) {
    const TemporaryFolder folder;
    const std::string cache = (folder / "cache").string();
    std::vector<std::future<Ran>> runs;
    for (int i = 0; i < 3; ++i)
        runs.push_back(std::async(std::launch::async, [&, i] {
            return drawn(folder, std::to_string(i) + ".png", cache);
        }));
    for (auto& run : runs) EXPECT_EQ(run.get().exit, 0);
    EXPECT_TRUE(text_of(folder / "0.png") == text_of(folder / "1.png"));
    EXPECT_TRUE(text_of(folder / "0.png") == text_of(folder / "2.png"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "cache/facet/environments"), {}), 1);
}

}  // namespace
}  // namespace facet::cli
