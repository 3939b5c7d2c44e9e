// Files: reading whole ones safely, writing them so that a reader never sees half of one.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facet::base {

using Bytes = std::vector<std::byte>;

/// The whole of a regular file. Errors: input_invalid (errno's text, "is a directory", "not a
/// regular file"), limit_reached above `max_bytes`. Never blocks on a FIFO or device.
[[nodiscard]] Result<Bytes> read_file(const std::filesystem::path& path, std::size_t max_bytes);

/// The same as text, whatever its encoding. Every error names the file.
[[nodiscard]] Result<std::string> read_text_file(const std::filesystem::path& path,
                                                 std::size_t max_bytes);

/// The whole of a file below `folder`, for a `relative` path that came from another file. Refuses
/// with input_invalid whatever leaves the folder after resolving `..` and symbolic links, and
/// whatever is not a regular file; `allowed` are further folders that may be read (--allow-read).
/// No search path, no network.
[[nodiscard]] Result<Bytes> read_file_beneath(const std::filesystem::path& folder,
                                              std::string_view relative,
                                              std::span<const std::filesystem::path> allowed,
                                              std::size_t max_bytes);

/// Whether `path` is `folder` or lies in it; both resolved of links. Nothing is in an empty folder.
[[nodiscard]] bool is_beneath(const std::filesystem::path& path,
                              const std::filesystem::path& folder);

/// Everything on standard input. Errors: limit_reached above `max_bytes`.
[[nodiscard]] Result<Bytes> read_stdin(std::size_t max_bytes);

/// Whether `path` can be written: its folder exists and may be written, and it is not a directory.
/// Errors: usage (no such folder), input_invalid (not writable).
[[nodiscard]] Status check_writable(const std::filesystem::path& path);

/// Whether a write waits until the disk has it: else a power cut may leave an empty or torn file.
enum class Sync : std::uint8_t { yes, no };
/// Writes `bytes` to a temporary name beside `path`, syncs, renames. On any error the old file is
/// untouched and no temporary is left. Errors: temporary (disk full, fsync), input_invalid (not
/// writable).
[[nodiscard]] Status write_file_atomically(const std::filesystem::path& path,
                                           std::span<const std::byte> bytes, Sync sync = Sync::yes);

}  // namespace facet::base
