// Maps that glTF has no slot for, in the studio: the picture follows every edit of them and its
// undoing, and is the one that the command draws. SPDX-License-Identifier: MIT
#include "studio/run_script.h"

#include <gtest/gtest.h>

namespace facet::studio {
namespace {

using support::text_of;

const std::vector<std::string> small_and_fast{
    "--size", "120x80", "--samples", "2", "--shadows", "off", "--env", "studio", "--exposure", "1"};

/// The bytes of what the command draws with an edit.
std::string drawn(const support::TemporaryFolder& folder, const std::string& scene,
                  const std::string& edit) {
    std::vector<std::string> all{"render", scene, "-o", "drawn.png", "--set", edit};
    all.insert(all.end(), small_and_fast.begin(), small_and_fast.end());
    const support::Ran ran = support::facet(all, {.folder = folder.path()});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    return text_of(folder / "drawn.png");
}

void in_studio(const support::TemporaryFolder& folder, const std::string& scene,
               const std::string& script) {
    const support::Ran ran = test::run_script(folder, scene, "640x400", script, small_and_fast);
    ASSERT_EQ(ran.exit, 0) << ran.err;
}

TEST(StudioHeightMap, FollowsItsSliderItsTextureAndUndo) {
    const support::TemporaryFolder folder;
    const std::string scene = "builtin:relief";
    in_studio(folder, scene,
              "wait\nset material.cobbles.height_scale_m 0.06\nwait\nsave raised.png\nwait\n"
              "set material.cobbles.height_texture none\nwait\nsave flat.png\nwait\n"
              "undo\nwait\nsave again.png\nwait\n");
    EXPECT_TRUE(text_of(folder / "raised.png") ==
                drawn(folder, scene, "material.cobbles.height_scale_m=0.06"));
    EXPECT_TRUE(text_of(folder / "flat.png") ==
                drawn(folder, scene, "material.cobbles.height_texture=none"));
    EXPECT_TRUE(text_of(folder / "again.png") == text_of(folder / "raised.png"));
    EXPECT_FALSE(text_of(folder / "flat.png") == text_of(folder / "raised.png"));
}

TEST(StudioFresnelMap, FollowsItsTextureAndUndo) {
    const support::TemporaryFolder folder;
    const std::string scene = "builtin:ball";
    in_studio(folder, scene,
              "wait\nsave plain.png\nwait\n"
              "set material.ball.fresnel_ramp_texture builtin:pearl_ramp\nwait\n"
              "save pearl.png\nwait\nundo\nwait\nsave undone.png\nwait\n");
    EXPECT_TRUE(text_of(folder / "pearl.png") ==
                drawn(folder, scene, "material.ball.fresnel_ramp_texture=builtin:pearl_ramp"));
    EXPECT_TRUE(text_of(folder / "undone.png") == text_of(folder / "plain.png"));
    EXPECT_FALSE(text_of(folder / "pearl.png") == text_of(folder / "plain.png"));
}

}  // namespace
}  // namespace facet::studio
