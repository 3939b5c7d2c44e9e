// Files: the path gate lets nothing out, and a write leaves a whole file or nothing.
// SPDX-License-Identifier: MIT
#include "base/file.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>
#include <sys/stat.h>
#include <unistd.h>

namespace facet::base {
namespace {

namespace fs = std::filesystem;
using support::TemporaryFolder;
using support::text_of;

constexpr std::size_t most = 1 << 20;

std::string text_of(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

TEST(ReadFile, GivesTheWholeFile) {
    const TemporaryFolder folder;
    const std::string big(300'000, 'q');
    EXPECT_EQ(text_of(read_file(folder.write("a", big), most).value()), big);
    EXPECT_EQ(text_of(read_file(folder.write("empty", ""), most).value()), "");
}
TEST(ReadFile, NamesTheFileThatIsNotThere) {
    const auto read = read_file("/nowhere/at/all", most);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::input_invalid);
    EXPECT_EQ(read.error().file, "/nowhere/at/all");
}
TEST(ReadFile, RefusesAFolder) {
    const TemporaryFolder folder;
    EXPECT_EQ(read_file(folder.path(), most).error().what, "is a directory");
}
TEST(ReadFile, RefusesADevice) {
    EXPECT_EQ(read_file("/dev/zero", most).error().what, "not a regular file");
}
TEST(ReadFile, DoesNotWaitAtAFifo) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    EXPECT_EQ(read_file(folder / "fifo", most).error().what, "not a regular file");
}
TEST(ReadFile, RefusesMoreThanTheLimit) {
    const TemporaryFolder folder;
    const auto file = folder.write("a", "12345");
    EXPECT_EQ(read_file(file, 4).error().code, ErrorCode::limit_reached);
    EXPECT_TRUE(read_file(file, 5));
}

/// scene/ with a texture, and a secret beside it.
struct Gate : testing::Test {
    TemporaryFolder folder;
    fs::path scene = folder / "scene";
    void SetUp() override {
        folder.write("scene/textures/a.png", "inside");
        folder.write("secret.txt", "outside");
    }
    Result<Bytes> read(std::string_view relative, std::vector<fs::path> allowed = {}) const {
        return read_file_beneath(scene, relative, allowed, most);
    }
};
TEST_F(Gate, OpensWhatLiesBeneath) {
    EXPECT_EQ(text_of(read("textures/a.png").value()), "inside");
    EXPECT_EQ(text_of(read("textures/../textures/./a.png").value()), "inside");
}
TEST_F(Gate, RefusesToLeaveByDots) {
    const auto result = read("../secret.txt");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::input_invalid);
    EXPECT_EQ(result.error().what, "outside the model's folder");
}
TEST_F(Gate, RefusesAnAbsolutePath) { EXPECT_FALSE(read((folder / "secret.txt").string())); }
TEST_F(Gate, RefusesALinkThatLeaves) {
    fs::create_symlink(folder / "secret.txt", scene / "link.png");
    fs::create_directory_symlink(folder.path(), scene / "up");
    EXPECT_FALSE(read("link.png"));
    EXPECT_FALSE(read("up/secret.txt"));
}
TEST_F(Gate, FollowsALinkThatStays) {
    fs::create_symlink("textures/a.png", scene / "b.png");
    EXPECT_EQ(text_of(read("b.png").value()), "inside");
}
TEST_F(Gate, OpensAFolderThatIsAllowed) {
    EXPECT_EQ(text_of(read("../secret.txt", {folder.path()}).value()), "outside");
}
TEST_F(Gate, AnAllowedFolderThatIsNoneAllowsNothing) {
    EXPECT_FALSE(read("../secret.txt", {""}));
    EXPECT_FALSE(read("../secret.txt", {folder / "nope"}));
    EXPECT_FALSE(read("../secret.txt", {fs::path(std::string(5000, 'x'))}));
}
TEST_F(Gate, ASiblingWhoseNameBeginsAlikeIsOutside) {
    folder.write("scene-two/a.png", "outside");
    EXPECT_FALSE(read("../scene-two/a.png"));
}
TEST_F(Gate, RefusesDevicesFifosAndNothing) {
    ASSERT_EQ(::mkfifo((scene / "fifo").c_str(), 0600), 0);
    EXPECT_FALSE(read("fifo"));
    EXPECT_FALSE(read("/dev/zero"));
    EXPECT_FALSE(read(""));
    EXPECT_FALSE(read("."));
    EXPECT_FALSE(read(std::string_view("textures/a.png\0x", 16)));
    EXPECT_FALSE(read("missing.png"));
}

TEST(WriteFileAtomically, ReplacesTheFileAndLeavesNothingElse) {
    const TemporaryFolder folder;
    const auto file = folder.write("a.png", "old");
    ASSERT_TRUE(write_file_atomically(file, bytes_of("new")));
    EXPECT_EQ(text_of(file), "new");
    EXPECT_EQ(folder.entry_count(), 1);
}
TEST(WriteFileAtomically, GivesTheModeThatTheUmaskAllows) {
    const TemporaryFolder folder;
    const mode_t before = ::umask(0027);
    ASSERT_TRUE(write_file_atomically(folder / "a", bytes_of("x")));
    ::umask(before);
    EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms(0640));
}
TEST(WriteFileAtomically, OnAnErrorTheOldFileStaysAndNoTemporary) {
    const TemporaryFolder folder;
    folder.write("target/inner", "kept");  // a folder cannot be replaced
    const auto written = write_file_atomically(folder / "target", bytes_of("new"));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().what, "is a directory");
    EXPECT_EQ(folder.entry_count(), 1);
    EXPECT_EQ(text_of(folder / "target/inner"), "kept");
}
TEST(WriteFileAtomically, TakesOverTheTemporaryOfADeadProcess) {
    const TemporaryFolder folder;
    folder.write(fmt::format(".a.png.{}.tmp", ::getpid()), "half");
    ASSERT_TRUE(write_file_atomically(folder / "a.png", bytes_of("new")));
    EXPECT_EQ(text_of(folder / "a.png"), "new");
    EXPECT_EQ(folder.entry_count(), 1);
}
TEST(WriteFileAtomically, WritesANameOfTheGreatestLength) {
    const TemporaryFolder folder;
    const auto file = folder / std::string(255, 'n');
    ASSERT_TRUE(write_file_atomically(file, bytes_of("new")));
    EXPECT_EQ(text_of(file), "new");
    EXPECT_EQ(write_file_atomically(folder / std::string(256, 'n'), {}).error().code,
              ErrorCode::input_invalid);
}
TEST(WriteFileAtomically, FollowsALinkWithinTheFolderAndRefusesOneThatLeaves) {
    const TemporaryFolder folder;
    folder.write("in/real.png", "old");
    folder.write("other/real.png", "old");
    fs::create_symlink("real.png", folder / "in/near.png");
    fs::create_symlink(folder / "other/real.png", folder / "in/far.png");
    ASSERT_TRUE(write_file_atomically(folder / "in/near.png", bytes_of("new")));
    EXPECT_EQ(text_of(folder / "in/real.png"), "new");
    EXPECT_TRUE(fs::is_symlink(folder / "in/near.png"));
    EXPECT_FALSE(write_file_atomically(folder / "in/far.png", bytes_of("new")));
    EXPECT_EQ(text_of(folder / "other/real.png"), "old");
}

TEST(CheckWritable, TellsAMissingFolderFromAFolder) {
    const TemporaryFolder folder;
    EXPECT_TRUE(check_writable(folder / "a.png"));
    EXPECT_EQ(check_writable(folder / "no/a.png").error().code, ErrorCode::usage);
    EXPECT_EQ(check_writable(folder.path()).error().code, ErrorCode::input_invalid);
    EXPECT_EQ(check_writable("/dev/null").error().code, ErrorCode::input_invalid);
    EXPECT_EQ(folder.entry_count(), 0);
}

}  // namespace
}  // namespace facet::base
