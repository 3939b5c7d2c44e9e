// Files that are found again: only whole ones, of one's own, and never more than the limit.
// SPDX-License-Identifier: MIT
#include "base/disk_cache.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace facet::base {
namespace {

namespace fs = std::filesystem;
using support::TemporaryFolder;

const std::string cache_key(64, 'a');

Bytes some_bytes(std::size_t count, unsigned seed = 1) {
    Bytes out(count);
    for (std::size_t i = 0; i < count; ++i)
        out[i] = static_cast<std::byte>((i * 31 + seed * 7) & 0xFFU);
    return out;
}

/// A cache in a folder that is not there yet.
struct DiskCacheTest : testing::Test {
    TemporaryFolder folder;
    fs::path inner = folder / "one/two";
    ThreadPool pool{2};
    DiskCache cache{inner};

    [[nodiscard]] Bytes found(const std::string& key = cache_key) {
        const auto entry = cache.find(key, pool);
        if (!entry) return {};
        const auto payload = entry->payload();
        return {payload.begin(), payload.end()};
    }
    [[nodiscard]] fs::path file(const std::string& key = cache_key) const {
        return inner / (key + ".entry");
    }
    [[nodiscard]] std::ptrdiff_t file_count() const {
        return std::distance(fs::directory_iterator(inner), {});
    }
};

TEST_F(DiskCacheTest, GivesBackWhatWasPut) {
    // More than a block of the hash.
    const Bytes bytes = some_bytes(3'000'001);
    EXPECT_FALSE(cache.find(cache_key, pool));
    ASSERT_TRUE(cache.put(cache_key, bytes, pool));
    EXPECT_EQ(found(), bytes);
    EXPECT_TRUE(found(std::string(64, 'b')).empty());
    EXPECT_EQ(file_count(), 1);
    struct stat status {};
    ASSERT_EQ(::stat(inner.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0700U);
}

TEST_F(DiskCacheTest, DeletesAFileThatIsNotWhole) {
    const Bytes bytes = some_bytes(5000);
    const auto bent = [&](std::size_t at) {
        std::string text = support::text_of(file());
        text[at] = static_cast<char>(text[at] ^ 1);
        return text;
    };
    ASSERT_TRUE(cache.put(cache_key, bytes, pool));
    const std::string whole = support::text_of(file());
    std::vector<std::string> wrong = {"",
                                      "x",
                                      whole.substr(0, 100),
                                      whole.substr(0, 152),
                                      whole.substr(0, whole.size() - 1),
                                      whole + "x"};
    for (std::size_t at : {0, 8, 12, 16, 24, 90, 152, 3000}) wrong.push_back(bent(at));
    for (const std::string& text : wrong) {
        folder.write("one/two/" + cache_key + ".entry", text);
        EXPECT_FALSE(cache.find(cache_key, pool)) << text.size();
        EXPECT_FALSE(fs::exists(file())) << text.size();
        ASSERT_TRUE(cache.put(cache_key, bytes, pool));
        EXPECT_EQ(found(), bytes);
    }
}

TEST_F(DiskCacheTest, TakesNoEntryOfAnotherKey) {
    ASSERT_TRUE(cache.put(cache_key, some_bytes(100), pool));
    const std::string other(64, 'c');
    fs::rename(file(), file(other));
    EXPECT_FALSE(cache.find(other, pool));
}

TEST_F(DiskCacheTest, FollowsNoLinkAndWaitsAtNoFifo) {
    ASSERT_TRUE(cache.put(cache_key, some_bytes(100), pool));
    fs::rename(file(), folder / "elsewhere");
    fs::create_symlink(folder / "elsewhere", file());
    EXPECT_FALSE(cache.find(cache_key, pool));
    EXPECT_TRUE(fs::exists(folder / "elsewhere"));
    ASSERT_EQ(::mkfifo(file().c_str(), 0600), 0);
    EXPECT_FALSE(cache.find(cache_key, pool));
}

TEST_F(DiskCacheTest, BelievesNothingWhereOthersMayWrite) {
    ASSERT_TRUE(cache.put(cache_key, some_bytes(100), pool));
    for (const mode_t mode : {0777, 0720, 0702}) {
        ASSERT_EQ(::chmod(inner.c_str(), mode), 0);
        EXPECT_FALSE(cache.find(cache_key, pool));
        const auto put = cache.put(cache_key, some_bytes(100), pool);
        ASSERT_FALSE(put);
        EXPECT_NE(put.error().found.find("others may write"), std::string::npos);
        EXPECT_NE(put.error().remedy.find("FACET_CACHE=off"), std::string::npos);
    }
    EXPECT_TRUE(fs::exists(file()));
}

TEST_F(DiskCacheTest, SaysThatAFolderOfAnotherUserIsNotUsed) {
    ASSERT_TRUE(cache.put(cache_key, some_bytes(100), pool));
    if (::chown(inner.c_str(), 12345, 12345) != 0) GTEST_SKIP() << "only root gives folders away";
    EXPECT_FALSE(cache.find(cache_key, pool));
    EXPECT_NE(cache.put(cache_key, some_bytes(100), pool).error().found.find("another user"),
              std::string::npos);
}

TEST_F(DiskCacheTest, ReadsWhatItMayNotWrite) {
    ASSERT_TRUE(cache.put(cache_key, some_bytes(100), pool));
    ASSERT_EQ(::chmod(inner.c_str(), 0500), 0);
    EXPECT_EQ(found(), some_bytes(100));
    const bool is_root = ::geteuid() == 0;  // to whom nothing is read-only
    EXPECT_EQ(cache.put(std::string(64, 'd'), some_bytes(100), pool).has_value(), is_root);
    ASSERT_EQ(::chmod(inner.c_str(), 0700), 0);
}

TEST_F(DiskCacheTest, SaysWhereNoFolderCanBe) {
    folder.write("file", "");
    for (const fs::path& nowhere : {folder / "file/two", fs::path("/proc/facet/two")}) {
        const DiskCache none(nowhere);
        EXPECT_FALSE(none.find(cache_key, pool));
        const auto put = none.put(cache_key, some_bytes(100), pool);
        ASSERT_FALSE(put);
        EXPECT_EQ(put.error().file, nowhere.string());
    }
}

TEST_F(DiskCacheTest, IsMadeAgainAfterItWasDeleted) {
    ASSERT_TRUE(cache.put(cache_key, some_bytes(100), pool));
    fs::remove_all(folder / "one");
    EXPECT_FALSE(cache.find(cache_key, pool));
    ASSERT_TRUE(cache.put(cache_key, some_bytes(100), pool));
    EXPECT_EQ(found(), some_bytes(100));
}

TEST_F(DiskCacheTest, DropsWhatWasNotUsedForLongest) {
    const DiskCache small(inner, 3000);
    const std::string keys[] = {std::string(64, '0'), std::string(64, '1'), std::string(64, '2')};
    const auto age = [&](const std::string& key, int hours) {
        fs::last_write_time(file(key),
                            fs::file_time_type::clock::now() - std::chrono::hours(hours));
    };
    ASSERT_TRUE(small.put(keys[0], some_bytes(1000), pool));
    ASSERT_TRUE(small.put(keys[1], some_bytes(1000), pool));
    age(keys[0], 3);
    age(keys[1], 2);
    EXPECT_TRUE(small.find(keys[0], pool));  // now the younger one
    ASSERT_TRUE(small.put(keys[2], some_bytes(1000), pool));
    EXPECT_TRUE(small.find(keys[0], pool));
    EXPECT_FALSE(small.find(keys[1], pool));
    EXPECT_TRUE(small.find(keys[2], pool));
    EXPECT_TRUE(small.put(keys[1], some_bytes(4000), pool));  // more than all there is room for
    EXPECT_EQ(file_count(), 2);
}

TEST_F(DiskCacheTest, ClearsAwayWritesThatWereCutOffLongAgo) {
    ASSERT_TRUE(cache.put(cache_key, some_bytes(100), pool));
    folder.write("one/two/.old.entry.1.tmp", "x");
    folder.write("one/two/.new.entry.2.tmp", "x");
    fs::last_write_time(folder / "one/two/.old.entry.1.tmp",
                        fs::file_time_type::clock::now() - std::chrono::hours(48));
    ASSERT_TRUE(cache.put(cache_key, some_bytes(100), pool));
    EXPECT_FALSE(fs::exists(folder / "one/two/.old.entry.1.tmp"));
    EXPECT_TRUE(fs::exists(folder / "one/two/.new.entry.2.tmp"));
}

// Four processes that put and find the same entries, in a folder that holds two of the three: each
// finds nothing, or what was put.
TEST_F(DiskCacheTest, SeveralProcessesShareAFolder) {
    std::vector<pid_t> children;
    for (unsigned process = 0; process < 4; ++process) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            ThreadPool own(1);
            const DiskCache shared(inner, 250'000);
            bool holds = true;
            for (unsigned i = 0; i < 60; ++i) {
                const unsigned seed = (i + process) % 3;
                const std::string key(64, static_cast<char>('0' + seed));
                const Bytes bytes = some_bytes(100'000 + seed, seed);
                if (const auto entry = shared.find(key, own))
                    holds = holds && std::ranges::equal(entry->payload(), bytes);
                else
                    holds = holds && shared.put(key, bytes, own).has_value();
            }
            ::_exit(holds ? 0 : 1);
        }
        children.push_back(child);
    }
    for (const pid_t child : children) {
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
    EXPECT_LE(file_count(), 3);
}

}  // namespace
}  // namespace facet::base
