// Files of what took long to compute, found again by a key of all that it hangs on.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "base/result.h"
#include "base/thread_pool.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace facet::base {

/// Files of any number of processes in one folder. Nothing hangs on them: they may be deleted,
/// bent, or not writable at any time.
class DiskCache {
public:
    static constexpr std::uint64_t usual_most_bytes = std::uint64_t{256} << 20U;
    /// `most_bytes`: of all files together; those that were not used for longest go first.
    explicit DiskCache(std::filesystem::path folder, std::uint64_t most_bytes = usual_most_bytes)
        : folder_(std::move(folder)), most_bytes_(most_bytes) {}

    /// A file that was found whole.
    struct Entry {
        Bytes file;
        [[nodiscard]] std::span<const std::byte> payload() const;
    };
    /// What was put under `key`, of hexadecimal digits. None where there is none, where it is not
    /// what was put (it is deleted then), or where others than this user may write to the folder.
    [[nodiscard]] std::optional<Entry> find(std::string_view key, ThreadPool& pool) const;

    /// Keeps it, unless it is too large; makes the folder at need. Errors, of which the text says
    /// how to do without: input_invalid (the folder is not writable, or not this user's alone),
    /// temporary (the disk is full).
    [[nodiscard]] Status put(std::string_view key, std::span<const std::byte> payload,
                             ThreadPool& pool) const;

private:
    [[nodiscard]] std::filesystem::path path_of(std::string_view key) const;
    void trim() const;

    std::filesystem::path folder_;
    std::uint64_t most_bytes_;
};

/// What stands in front of a payload in its file.
[[nodiscard]] Bytes entry_header(std::string_view key, std::span<const std::byte> payload,
                                 ThreadPool& pool);
/// Whether a file is what was put under `key`: its header, its size and its hash.
[[nodiscard]] bool is_whole_entry(std::span<const std::byte> file, std::string_view key,
                                  ThreadPool& pool);

}  // namespace facet::base
