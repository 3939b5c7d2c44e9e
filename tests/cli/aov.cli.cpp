// facet render --aov: which files come, and which light the terms are for.
// SPDX-License-Identifier: MIT
#include "support/process.h"
#include "support/temporary_folder.h"
#include "tables/aovs.h"

#include <gtest/gtest.h>

namespace facet::cli {
namespace {

using support::facet;
using support::Ran;
using support::TemporaryFolder;
using support::text_of;

constexpr const char* first_light = "directional:azimuth=60,elevation=30,lux=1";
constexpr const char* strong_light = "directional:azimuth=-80,elevation=10,lux=9000";

std::vector<std::string> render_spheres(const std::string& output, std::vector<std::string> more) {
    return support::draft_render("builtin:spheres", output, std::move(more));
}

TEST(AovOption, AllGivesASideFileARow) {
    const TemporaryFolder folder;
    for (const char* reference : {"", "1"}) {
        std::vector<std::string> more{"--aov", "all"};
        if (*reference != '\0') more.insert(more.end(), {"--reference", reference});
        const Ran ran = facet(render_spheres((folder / "a.png").string(), more));
        ASSERT_EQ(ran.exit, 0) << ran.err;
        for (const tables::AovRow& row : tables::aovs) {
            const auto side = folder / ("a." + std::string(row.key) + ".png");
            EXPECT_TRUE(std::filesystem::remove(side)) << row.key;
        }
    }
    EXPECT_EQ(folder.entry_count(), 1);
}

// n.l in a side file is the light's direction at every pixel.
TEST(AovOption, TheKeyLightIsTheFirstOfTheLightsGivenWhateverItsStrength) {
    const TemporaryFolder folder;
    const auto n_dot_l = [&](const std::string& name, const std::vector<std::string>& lights) {
        std::vector<std::string> more{"--aov", "n_dot_l"};
        for (const std::string& light : lights) more.insert(more.end(), {"--light", light});
        const Ran ran = facet(render_spheres((folder / (name + ".png")).string(), more));
        EXPECT_EQ(ran.exit, 0) << ran.err;
        return text_of(folder / (name + ".n_dot_l.png"));
    };
    const std::string both = n_dot_l("both", {first_light, strong_light});
    EXPECT_EQ(both, n_dot_l("first", {first_light}));
    EXPECT_NE(both, n_dot_l("strong", {strong_light}));
}

TEST(AovOption, EveryRowIsInTheListAndInTheHelp) {
    const Ran list = facet({"--list", "aovs"});
    const Ran help = facet({"help", "aovs"});
    for (const tables::AovRow& row : tables::aovs) {
        EXPECT_NE(list.out.find(std::string(row.key)), std::string::npos) << row.key;
        EXPECT_NE(help.out.find("  " + std::string(row.key) + " "), std::string::npos) << row.key;
    }
}

}  // namespace
}  // namespace facet::cli
