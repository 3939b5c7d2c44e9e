// facet render --reference and --compare: what is asked for, what comes back, and what is refused.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "image/read.h"
#include "support/process.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace facet::cli {
namespace {

using support::facet;
using support::Ran;
using support::TemporaryFolder;
using support::text_of;

std::vector<std::string> render_cornell(const std::string& output, std::vector<std::string> more) {
    return support::draft_render("builtin:cornell", output, std::move(more));
}

image::Picture picture(const std::filesystem::path& path) {
    const auto bytes = base::read_file(path, 1U << 24U);
    EXPECT_TRUE(bytes);
    auto read = image::decode_picture(*bytes, {});
    EXPECT_TRUE(read);
    return *read;
}

TEST(ReferenceCommand, SaysHowManySamplesAndHowNoisyItIs) {
    const TemporaryFolder folder;
    const Ran ran =
        facet(render_cornell((folder / "a.png").string(), {"--reference", "8", "--json"}));
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const auto object = nlohmann::json::parse(ran.out);
    EXPECT_EQ(object["reference"]["samples"], 8.0);
    EXPECT_EQ(object["reference"]["paths"], 48 * 32 * 8);
    EXPECT_GT(object["reference"]["noise"], 0.0);
    EXPECT_EQ(object["reference"]["stopped_by_time"], false);
    EXPECT_TRUE(object["warnings"].empty());
}

TEST(ReferenceCommand, UsesTheExposureOfTheRasterPicture) {
    const TemporaryFolder folder;
    const auto exposure = [&](std::vector<std::string> more) {
        more.emplace_back("--json");
        const Ran ran = facet(render_cornell((folder / "a.png").string(), more));
        EXPECT_EQ(ran.exit, 0) << ran.err;
        return nlohmann::json::parse(ran.out)["exposure"].get<double>();
    };
    EXPECT_EQ(exposure({}), exposure({"--reference", "2"}));
}

TEST(ReferenceCommand, WritesTheSameBytesForAnyNumberOfThreads) {
    const TemporaryFolder folder;
    ASSERT_EQ(facet(render_cornell((folder / "1.exr").string(),
                                   {"--reference", "4", "--aov", "all", "--threads", "1"}))
                  .exit,
              0);
    ASSERT_EQ(facet(render_cornell((folder / "3.exr").string(),
                                   {"--reference", "4", "--aov", "all", "--threads", "3"}))
                  .exit,
              0);
    EXPECT_EQ(text_of(folder / "1.exr"), text_of(folder / "3.exr"));
}

TEST(ReferenceCommand, GoesOnUntilTheNoiseAskedForAndEndsAtItsTimeLimit) {
    const TemporaryFolder folder;
    const Ran quiet =
        facet(render_cornell((folder / "a.png").string(), {"--reference", "auto:0.05", "--json"}));
    ASSERT_EQ(quiet.exit, 0) << quiet.err;
    EXPECT_LE(nlohmann::json::parse(quiet.out)["reference"]["noise"], 0.05);
    const Ran hurried = facet(render_cornell(
        (folder / "a.png").string(), {"--reference", "1000000", "--time-limit", "0.2", "--json"}));
    ASSERT_EQ(hurried.exit, 0) << hurried.err;
    const auto object = nlohmann::json::parse(hurried.out);
    EXPECT_EQ(object["reference"]["stopped_by_time"], true);
    EXPECT_GE(object["reference"]["samples"], 1.0);
    EXPECT_EQ(object["warnings"].size(), 1U);
}

TEST(ReferenceCommand, RefusesWhatItCannotUnderstand) {
    const TemporaryFolder folder;
    const auto out = (folder / "a.png").string();
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--reference", "0"},
                                                  {"--reference", "auto:2"},
                                                  {"--reference", "auto"},
                                                  {"--reference", "many"},
                                                  {"--compare"},
                                                  {"--time-limit", "3"},
                                                  {"--reference", "4", "--time-limit", "-1"}}) {
        const Ran ran = facet(render_cornell(out, wrong));
        EXPECT_EQ(ran.exit, 2) << wrong.front() << ran.err;
        EXPECT_TRUE(ran.err.starts_with("facet: --")) << ran.err;
    }
    EXPECT_EQ(folder.entry_count(), 0);
}

TEST(ReferenceCommand, HasLightsWithASizeAsTheRasteriserHasWithRaysAndWithout) {
    const TemporaryFolder folder;
    const auto out = (folder / "a.png").string();
    std::vector<std::string> light{"--light",
                                   "rect:lumen=500,width=0.5,height=0.5,position=0 1.5 1"};
    EXPECT_EQ(facet(render_cornell(out, light)).exit, 0);
    light.insert(light.end(), {"--shadows", "off"});
    EXPECT_EQ(facet(render_cornell(out, light)).exit, 0);
    light.insert(light.end(), {"--reference", "2"});
    EXPECT_EQ(facet(render_cornell(out, light)).exit, 0);
    light.emplace_back("--compare");
    EXPECT_EQ(facet(render_cornell(out, light)).exit, 0);
}

TEST(Compare, LaysRasterReferenceAndDifferenceSideBySideWithTheNumbers) {
    const TemporaryFolder folder;
    const Ran ran = facet(
        render_cornell((folder / "c.png").string(), {"--reference", "4", "--compare", "--json"}));
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const auto object = nlohmann::json::parse(ran.out);
    for (const char* key : {"rmse", "psnr", "max", "flip", "pixels"})
        EXPECT_TRUE(object["compared"].contains(key)) << key;
    EXPECT_GT(object["compared"]["rmse"], 0.01);
    const auto panels = picture(folder / "c.png");
    EXPECT_EQ(panels.layers.front().image.size.width, object["width"]);
    EXPECT_GE(panels.layers.front().image.size.width, 3U * 48U);
}

TEST(Compare, IsThreeLayersOfAnExrAndNothingOfAnHdr) {
    const TemporaryFolder folder;
    ASSERT_EQ(
        facet(render_cornell((folder / "c.exr").string(), {"--reference", "4", "--compare"})).exit,
        0);
    const auto layers = picture(folder / "c.exr");
    std::vector<std::string> names;
    for (const auto& layer : layers.layers) names.push_back(layer.name);
    for (const char* name : {"", "reference", "difference"})
        EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
    EXPECT_EQ(
        facet(render_cornell((folder / "c.hdr").string(), {"--reference", "4", "--compare"})).exit,
        2);
}

}  // namespace
}  // namespace facet::cli
