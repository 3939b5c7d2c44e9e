// Unsaved work: what is kept is found again, and never that of a session that still runs.
// SPDX-License-Identifier: MIT
#include "studio/recovery.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

namespace facet::studio {
namespace {

using support::TemporaryFolder;

Document work() {
    Document document{"a b.glb", {}};
    document.settings.env = "sky";
    document.settings.size = {320, 200};
    set_path(document.settings, "material[2].base_color", "0.1 0.2 0.3");
    return document;
}

TEST(Recovery, WhatIsKeptReadsBackToTheSameDocument) {
    const auto again = parse_recovery(recovery_text(work()));
    ASSERT_TRUE(again) << base::to_line(again.error());
    EXPECT_EQ(again->scene, work().scene);
    EXPECT_TRUE(again->settings == work().settings);
}

TEST(Recovery, WorkOfAnEndedSessionIsFoundAndThatOfARunningOneIsNot) {
    const TemporaryFolder folder;
    Recovery recovery(folder.path());
    ASSERT_TRUE(recovery.keep(work()));
    EXPECT_EQ(folder.entry_count(), 1);
    EXPECT_FALSE(recovery.find()) << "this process is alive";
    // The largest process number of Linux is 2^22: nobody has this one.
    folder.write("studio-99999999.json", recovery_text(work()));
    folder.write("studio-99999998.json", "{");
    const auto found = recovery.find();
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->document.settings == work().settings);
    recovery.drop();
    EXPECT_EQ(folder.entry_count(), 2);
}

TEST(Recovery, RefusesWhatItDidNotWrite) {
    for (const char* text : {"", "[]", "{}", R"({"facet":1})",
                             R"({"facet":1,"scene":"a","settings":{"sise":["1x1"]}})",
                             R"({"facet":1,"scene":"a","settings":{"size":["1"]}})",
                             R"({"facet":1,"scene":"a","settings":{"ev":[3]}})",
                             R"({"facet":2,"scene":"a","settings":{}})"}) {
        const auto document = parse_recovery(text);
        ASSERT_FALSE(document) << text;
        EXPECT_EQ(document.error().code, base::ErrorCode::input_invalid) << text;
    }
}

}  // namespace
}  // namespace facet::studio
