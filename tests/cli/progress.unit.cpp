// The progress line's text.
// SPDX-License-Identifier: MIT
#include "cli/progress.h"

#include <gtest/gtest.h>

namespace facet::cli {
namespace {

TEST(ProgressText, HasShareNumbersAndTimeLeft) {
    EXPECT_EQ(progress_text(0.25, "64 of 256 samples", 10.0, false),
              " 25 %  64 of 256 samples  30 s left");
    EXPECT_EQ(progress_text(0.5, "x", 1.0, true), "[############------------]  50 %  x  1 s left");
    EXPECT_EQ(progress_text(0.01, "x", 10.0, false), "  1 %  x  16 min 30 s left");
    EXPECT_EQ(progress_text(0.001, "x", 10.0, false), "  0 %  x  2 h 46 min left");
}
TEST(ProgressText, NeverSaysSixtySeconds) {
    EXPECT_EQ(progress_text(0.5, "x", 239.7, false), " 50 %  x  4 min 00 s left");
}
TEST(ProgressText, KeepsWithinItsBarAndSaysNoTimeBeforeItCan) {
    EXPECT_EQ(progress_text(0.0, "x", 5.0, true), "[------------------------]   0 %  x");
    EXPECT_EQ(progress_text(1.5, "x", 5.0, true), "[########################] 100 %  x  0 s left");
}

}  // namespace
}  // namespace facet::cli
