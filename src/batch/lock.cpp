// Locks that keep two runs of one job apart.
// SPDX-License-Identifier: MIT
#include "batch/lock.h"

#include "base/file.h"
#include "base/text.h"

#include <fcntl.h>
#include <signal.h>
#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <thread>

namespace facet::batch {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;
using base::Result;

constexpr std::size_t most_written = 4096;

std::string host() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "?";
}

std::string boot_id() {
    const auto text = base::read_text_file("/proc/sys/kernel/random/boot_id", most_written);
    return text ? std::string(base::trimmed(*text)) : "?";
}

/// "pid 12 on host A since 2026-11-28T12:00:00Z"
std::string self() {
    const std::time_t now = std::time(nullptr);
    return fmt::format("pid {} on host {} since {:%Y-%m-%dT%H:%M:%SZ}", ::getpid(), host(),
                       fmt::gmtime(now));
}

std::string owner_of(const fs::path& path) {
    const auto text = base::read_text_file(path, most_written);
    return text ? std::string(base::trimmed(*text)) : "";
}

tl::unexpected<base::Error> locked(const fs::path& path) {
    const std::string owner = owner_of(path);
    return base::fail({.code = ErrorCode::temporary,
                       .file = path.string(),
                       .what = "locked by " + (owner.empty() ? "another run" : owner),
                       .remedy = "--wait SECONDS waits for it"});
}

Result<int> open_lock(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file >= 0) return file;
    return base::fail({.code = errno == ENOSPC ? ErrorCode::temporary : ErrorCode::input_invalid,
                       .file = path.string(),
                       .what = std::string("cannot write: ") + std::strerror(errno)});
}

bool has_no_locks(int error) { return error == ENOLCK || error == ENOTSUP || error == ENOSYS; }

/// Whether the file that stands for a lock was left by a process of this host that is gone.
bool is_left_behind(const fs::path& path) {
    const std::string text = owner_of(path);
    const auto words = base::split(text, ' ');
    if (words.size() < 2 || !text.ends_with(" boot " + boot_id())) return false;
    const auto pid = base::parse_integer(words[1]);
    return pid && ::kill(static_cast<pid_t>(*pid), 0) != 0 && errno == ESRCH;
}

/// A lock by a file's mere existence.
Result<int> take_by_name(const fs::path& path) {
    if (is_left_behind(path)) ::unlink(path.c_str());
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file < 0) return locked(path);
    const std::string text = self() + " boot " + boot_id();
    static_cast<void>(!::write(file, text.data(), text.size()));
    return file;
}

std::string name_of_count(std::size_t count) { return fmt::format("of-{}.lock", count); }

/// Files of other shard counts that a run holds now.
Result<bool> is_split_otherwise(const fs::path& folder, std::size_t count) {
    std::error_code error;
    for (auto entry = fs::directory_iterator(folder, error);
         !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with("of-") || !name.ends_with(".lock") || name == name_of_count(count))
            continue;
        const int file = ::open(entry->path().c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
        if (file < 0) continue;
        const bool is_held = ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        ::close(file);
        if (is_held) return true;
    }
    return false;
}

}  // namespace

ShardLock::~ShardLock() {
    if (!owned_.empty()) ::unlink(owned_.c_str());
    for (const int file : files_) ::close(file);
}

Result<ShardLock> ShardLock::take(const fs::path& folder, const Shard& shard,
                                  std::chrono::milliseconds patience, base::Warnings& warnings) {
    const fs::path shared = folder / name_of_count(shard.count);
    const fs::path own = folder / fmt::format("{}-of-{}.lock", shard.index, shard.count);
    const auto until = std::chrono::steady_clock::now() + patience;
    while (true) {
        ShardLock lock;
        const auto wait = [&] {
            if (std::chrono::steady_clock::now() >= until) return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            return true;
        };
        const auto common = open_lock(shared);
        if (!common) return tl::unexpected(common.error());
        lock.files_.push_back(*common);
        const auto file = open_lock(own);
        if (!file) return tl::unexpected(file.error());
        lock.files_.push_back(*file);
        if (::flock(*file, LOCK_EX | LOCK_NB) != 0) {
            if (has_no_locks(errno)) {
                fs::path name = own;
                name += ".held";
                const auto named = take_by_name(name);
                if (!named && wait()) continue;
                if (!named) return tl::unexpected(named.error());
                warnings.push_back({.file = folder.string(),
                                    .what = "the file system has no locks",
                                    .remedy = "a file stands for one, " + name.string()});
                lock.files_.push_back(*named);
                lock.owned_ = name;
                return lock;
            }
            if (wait()) continue;
            return locked(own);
        }
        const auto otherwise = ::flock(*common, LOCK_SH | LOCK_NB) != 0
                                   ? Result<bool>(true)
                                   : is_split_otherwise(folder, shard.count);
        if (!otherwise) return tl::unexpected(otherwise.error());
        if (*otherwise) {
            if (wait()) continue;
            return base::fail({.code = ErrorCode::temporary,
                               .file = folder.string(),
                               .what = "locked by a run of this job in other shards",
                               .remedy = "--wait SECONDS waits for it"});
        }
        const std::string text = self() + "\n";
        static_cast<void>(::ftruncate(*file, 0) != 0 ||
                          !::pwrite(*file, text.data(), text.size(), 0));
        return lock;
    }
}

}  // namespace facet::batch
