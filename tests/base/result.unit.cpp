// Errors as values: the line a user reads, and the exit codes.
// SPDX-License-Identifier: MIT
#include "base/result.h"

#include <gtest/gtest.h>

namespace facet::base {
namespace {

TEST(ToLine, HasTheFiveParts) {
    const Error error{.file = "a.gltf",
                      .where = "/meshes/0",
                      .what = "too many",
                      .found = "7",
                      .remedy = "use less"};
    EXPECT_EQ(to_line(error), "a.gltf:/meshes/0: too many (7); use less");
}
TEST(ToLine, LeavesOutWhatIsEmpty) {
    EXPECT_EQ(to_line(Error{.what = "no scene given"}), "no scene given");
    EXPECT_EQ(to_line(Error{.file = "a.glb", .what = "is empty"}), "a.glb: is empty");
}
TEST(ToLine, IsOneLineWhateverStandsInTheParts) {
    const Error error{
        .file = "a\nb", .where = "/\r", .what = "x\ny", .found = "\x1b[2J", .remedy = "z\n"};
    const std::string line = to_line(error);
    for (const char c : line) EXPECT_GE(static_cast<unsigned char>(c), 0x20U) << line;
}
TEST(ToLine, OfAWarningReadsLikeThatOfAnError) {
    EXPECT_EQ(
        to_line(Warning{.file = "a", .where = "/b", .what = "c", .found = "d", .remedy = "e"}),
        "a:/b: c (d); e");
}

TEST(InFile, KeepsAFileThatIsNamedAlready) {
    EXPECT_EQ(in_file(Error{.file = "texture.png"}, "scene.gltf").file, "texture.png");
    EXPECT_EQ(in_file(Error{}, "scene.gltf").file, "scene.gltf");
}

}  // namespace
}  // namespace facet::base
