// Files of what took long to compute, found again by a key of all that it hangs on.
// SPDX-License-Identifier: MIT
#include "base/disk_cache.h"

#include "base/hash.h"

#include <fcntl.h>
#include <spdlog/fmt/fmt.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

namespace facet::base {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view entry_ending = ".entry";
constexpr std::size_t digits = 64;
constexpr std::array<char, 8> entry_magic = {'F', 'A', 'C', 'E', 'T', 'K', 'P', 'T'};
/// Of the header; in another byte order it is another one.
constexpr std::uint32_t entry_version = 1;
/// Of a write that was cut off long ago, where the file system knows no nameless files.
constexpr auto left_behind = std::chrono::hours(24);

struct EntryHeader {
    std::array<char, 8> magic{};
    std::uint32_t version = 0;
    std::uint32_t header_bytes = 0;
    std::uint64_t payload_bytes = 0;
    std::array<char, digits> key{};
    std::array<char, digits> payload_sha256{};
};
static_assert(sizeof(EntryHeader) == 152 && std::is_trivially_copyable_v<EntryHeader>);

std::array<char, digits> padded(std::string_view text) {
    std::array<char, digits> out{};
    std::copy_n(text.begin(), std::min(text.size(), digits), out.begin());
    return out;
}

EntryHeader header_of(std::string_view key, std::span<const std::byte> payload, ThreadPool& pool) {
    return {.magic = entry_magic,
            .version = entry_version,
            .header_bytes = sizeof(EntryHeader),
            .payload_bytes = payload.size(),
            .key = padded(key),
            .payload_sha256 = padded(sha256_of_blocks(payload, pool))};
}

/// Why what lies there is not to be believed, or not to be written to; empty where it may.
std::string objection_to(const fs::path& folder) {
    struct stat status {};
    // A link that another made in a shared folder would lead to what is not the cache's.
    if (::lstat(folder.c_str(), &status) != 0) return std::generic_category().message(errno);
    if (status.st_uid != ::geteuid()) return "belongs to another user";
    if (::stat(folder.c_str(), &status) != 0) return std::generic_category().message(errno);
    if (!S_ISDIR(status.st_mode)) return "is no folder";
    if (status.st_uid != ::geteuid()) return "belongs to another user";
    if ((status.st_mode & (S_IWGRP | S_IWOTH)) != 0) return "others may write to it";
    return "";
}

tl::unexpected<Error> not_kept(ErrorCode code, const fs::path& folder, std::string why) {
    return fail({.code = code,
                 .file = folder.string(),
                 .what = "nothing is kept in this cache folder",
                 .found = std::move(why),
                 .remedy = "XDG_CACHE_HOME=DIR for another, or FACET_CACHE=off"});
}

struct KeptFile {
    fs::path path;
    fs::file_time_type used;
    std::uint64_t bytes = 0;
};

}  // namespace

Bytes entry_header(std::string_view key, std::span<const std::byte> payload, ThreadPool& pool) {
    const EntryHeader header = header_of(key, payload, pool);
    Bytes out(sizeof header);
    std::memcpy(out.data(), &header, sizeof header);
    return out;
}

bool is_whole_entry(std::span<const std::byte> file, std::string_view key, ThreadPool& pool) {
    EntryHeader found;
    if (file.size() < sizeof found) return false;
    std::memcpy(&found, file.data(), sizeof found);
    const auto payload = file.subspan(sizeof found);
    // The cheap ones first: a wrong file need not be hashed.
    if (found.magic != entry_magic || found.version != entry_version ||
        found.payload_bytes != payload.size() || found.key != padded(key))
        return false;
    const EntryHeader expected = header_of(key, payload, pool);
    return std::memcmp(&found, &expected, sizeof found) == 0;
}

std::span<const std::byte> DiskCache::Entry::payload() const {
    return std::span(file).subspan(sizeof(EntryHeader));
}

fs::path DiskCache::path_of(std::string_view key) const {
    return folder_ / (std::string(key) + std::string(entry_ending));
}

std::optional<DiskCache::Entry> DiskCache::find(std::string_view key, ThreadPool& pool) const {
    if (!objection_to(folder_).empty()) return std::nullopt;
    const fs::path path = path_of(key);
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0) return std::nullopt;
    auto file = S_ISREG(status.st_mode) ? read_file(path, most_bytes_) : Result<Bytes>(Bytes());
    if (!file) return std::nullopt;  // not readable now, or gone again
    if (!is_whole_entry(*file, key, pool)) {
        std::error_code error;
        fs::remove(path, error);
        return std::nullopt;
    }
    ::utimensat(AT_FDCWD, path.c_str(), nullptr, 0);  // used last: the last to go
    return Entry{std::move(*file)};
}

Status DiskCache::put(std::string_view key, std::span<const std::byte> payload,
                      ThreadPool& pool) const {
    if (payload.size() > most_bytes_ - std::min<std::uint64_t>(most_bytes_, sizeof(EntryHeader)))
        return {};
    std::error_code error;
    fs::create_directories(folder_.parent_path(), error);
    constexpr mode_t ours_alone = 0700;
    if (error || (::mkdir(folder_.c_str(), ours_alone) != 0 && errno != EEXIST))
        return not_kept(ErrorCode::input_invalid, folder_,
                        error ? error.message() : std::generic_category().message(errno));
    if (std::string why = objection_to(folder_); !why.empty())
        return not_kept(ErrorCode::input_invalid, folder_, std::move(why));
    Bytes file = entry_header(key, payload, pool);
    file.reserve(file.size() + payload.size());
    file.insert(file.end(), payload.begin(), payload.end());
    // What a power cut leaves of it is found out by its hash.
    if (auto written = write_file_atomically(path_of(key), file, Sync::no); !written)
        return not_kept(written.error().code, folder_, written.error().what);
    trim();
    return {};
}

void DiskCache::trim() const {
    std::error_code error;
    std::vector<KeptFile> files;
    std::uint64_t sum = 0;
    const auto now = fs::file_time_type::clock::now();
    for (fs::directory_iterator at(folder_, error), end; !error && at != end; at.increment(error)) {
        std::error_code gone;  // others delete too
        KeptFile file{at->path(), at->last_write_time(gone), at->file_size(gone)};
        if (gone) continue;
        const std::string ending = file.path.extension().string();
        if (ending == ".tmp" && now - file.used > left_behind) fs::remove(file.path, gone);
        if (ending != entry_ending) continue;
        sum += file.bytes;
        files.push_back(std::move(file));
    }
    std::ranges::sort(files, {}, &KeptFile::used);
    for (const KeptFile& file : files) {
        if (sum <= most_bytes_) return;
        fs::remove(file.path, error);
        sum -= file.bytes;
    }
}

}  // namespace facet::base
