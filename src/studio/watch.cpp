// Files that may change while they are shown.
// SPDX-License-Identifier: MIT
#include "studio/watch.h"

#include <system_error>

namespace facet::studio {

namespace fs = std::filesystem;

Watch::Time Watch::time_of(const fs::path& file) {
    std::error_code error;
    const Time time = fs::last_write_time(file, error);
    return error ? Time{} : time;
}

void Watch::set(const std::vector<fs::path>& files) {
    times_.clear();
    for (const fs::path& file : files) times_.emplace(file, time_of(file));
}

void Watch::set_folder(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error))
        if (at->is_regular_file(error)) files.push_back(at->path());
    set(files);
}

bool Watch::has_changed() {
    bool changed = false;
    for (auto& [file, time] : times_)
        if (const Time now = time_of(file); now != time) {
            time = now;
            // A file that is gone may be on its way back: editors write a new one and rename it.
            changed = changed || now != Time{};
        }
    return changed;
}

}  // namespace facet::studio
