// facet check, info and doctor: what they print and how they end.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "scene/animation_fixture.h"
#include "support/process.h"
#include "support/temporary_folder.h"
#include "tables/gltf_features.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace facet::cli {
namespace {

using nlohmann::json;
using support::facet;
using support::Ran;
using support::TemporaryFolder;

constexpr const char* empty_scene = R"({"asset":{"version":"2.0"}})";
constexpr const char* bad_scene =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":7}]})";

/// Every line as an object.
std::vector<json> objects(const std::string& text) {
    std::vector<json> out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        out.push_back(json::parse(text.substr(at, end - at)));
        at = end + 1;
    }
    return out;
}

TEST(Check, OfACleanSceneIsStatus0) {
    const TemporaryFolder folder;
    const Ran ran = facet({"check", folder.write("a.gltf", empty_scene).string()});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
}
TEST(Check, NamesThePointerOfAnErrorAndEndsWith1) {
    const TemporaryFolder folder;
    const auto file = folder.write("a.gltf", bad_scene).string();
    const Ran ran = facet({"check", file, "--json"});
    EXPECT_EQ(ran.exit, 1) << ran.err;
    const auto all = objects(ran.out);
    const auto found =
        std::ranges::find_if(all, [](const json& o) { return o["pointer"] == "/nodes/0/mesh"; });
    ASSERT_NE(found, all.end()) << ran.out;
    EXPECT_EQ((*found)["severity"], "error");
    EXPECT_EQ((*found)["code"], "UNRESOLVED_REFERENCE");
    EXPECT_EQ((*found)["path"], file);
}
TEST(Check, OfWhatCannotBeReadIsStatus3AndGoesOnWithTheRest) {
    const TemporaryFolder folder;
    const auto file = folder.write("a.gltf", empty_scene).string();
    const Ran ran = facet({"check", (folder / "missing.glb").string(), file});
    EXPECT_EQ(ran.exit, 3);
    EXPECT_NE(ran.out.find(file), std::string::npos) << ran.out;
}
TEST(Check, ListsWhatIsSupported) {
    const Ran ran = facet({"check", "--capabilities", "--json"});
    EXPECT_EQ(ran.exit, 0);
    const json told = json::parse(ran.out);
    EXPECT_FALSE(told["pictures_written"].empty());
    for (const json& row : told["gltf"]) {
        const auto test = row["test"].get<std::string>();
        EXPECT_EQ(row["loaded"] == "yes", !test.empty()) << row;
        const std::filesystem::path file = std::filesystem::path(FACET_SOURCE_DIR) / test;
        EXPECT_TRUE(test.empty() || std::filesystem::is_regular_file(file)) << row;
    }
}
TEST(Check, TheDocumentOnSupportIsWhatItPrints) {
    if (!tables::has_codec(tables::Codec::meshopt) || !tables::has_codec(tables::Codec::draco))
        GTEST_SKIP() << "a build without a codec supports less than the document says";
    const Ran ran = facet({"check", "--capabilities"});
    const auto text = base::read_text_file(
        std::filesystem::path(FACET_SOURCE_DIR) / "docs" / "support.md", 1U << 20U);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find(ran.out.substr(ran.out.find("| glTF"))), std::string::npos)
        << "docs/support.md: facet check --capabilities has another table";
}

TEST(Info, TellsWhatIsInAScene) {
    const Ran ran = facet({"info", "builtin:showcase", "--json"});
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const json info = objects(ran.out).back();
    EXPECT_GT(info["triangles"].get<int>(), 0);
    EXPECT_FALSE(info["materials"].empty());
    for (const char* key :
         {"textures", "cameras", "lights", "clips", "variants", "extensions", "extent"})
        EXPECT_TRUE(info.contains(key)) << key;
}
TEST(Info, TellsHowLongAnimationsAre) {
    const support::TemporaryFolder folder;
    const auto file = folder.write("a.gltf", test::moving().text()).string();
    const json info = objects(facet({"info", file, "--json"}).out).back();
    EXPECT_EQ(info["clips"], json::parse(R"([{"name": "animation 0", "seconds": 2.0}])"));
}
TEST(Info, OfAMissingFileIsStatus3) { EXPECT_EQ(facet({"info", "/nowhere.glb"}).exit, 3); }

TEST(Doctor, EndsWith0WhereARenderWorksAndTellsEachBackend) {
    const Ran ran = facet({"doctor", "--json"});
    const json report = objects(ran.out).back();
    const auto& backends = report["backends"];
    const bool works =
        std::ranges::any_of(backends, [](const json& b) { return b["works"].get<bool>(); });
    EXPECT_EQ(ran.exit, works ? 0 : 6) << ran.out;
    EXPECT_GE(backends.size(), 2U);
    for (const json& backend : backends)
        EXPECT_EQ(backend["works"].get<bool>(), backend["reason"] == "") << backend;
}

}  // namespace
}  // namespace facet::cli
