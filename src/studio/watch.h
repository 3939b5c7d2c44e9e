// Files that may change while they are shown.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <vector>

namespace facet::studio {

/// Tells which of its files were written since it looked last.
class Watch {
public:
    void set(const std::vector<std::filesystem::path>& files);
    /// Every file below `folder`.
    void set_folder(const std::filesystem::path& folder);
    /// True once for each change: a file that is written again, gone or back.
    [[nodiscard]] bool has_changed();

private:
    using Time = std::filesystem::file_time_type;
    [[nodiscard]] static Time time_of(const std::filesystem::path& file);
    std::map<std::filesystem::path, Time> times_;
};

}  // namespace facet::studio
