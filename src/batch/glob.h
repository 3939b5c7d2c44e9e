// Files by pattern.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace facet::batch {

[[nodiscard]] bool is_pattern(std::string_view text);

/// Paths below `folder` that a pattern means, relative to it as the pattern is written, sorted by
/// bytes: `*`, `?` and `[a-z]` within a name, `**` for any number of folders, whose links are not
/// followed. Names that begin with a dot only where the pattern says so. Absolute patterns work.
[[nodiscard]] std::vector<std::string> matching_files(const std::filesystem::path& folder,
                                                      const std::string& pattern);

}  // namespace facet::batch
