// Temporary files that a run which was killed left behind.
// SPDX-License-Identifier: MIT
#include "batch/leftovers.h"

#include "base/text.h"

#include <signal.h>

#include <cerrno>
#include <map>
#include <set>

namespace facet::batch {
namespace {

namespace fs = std::filesystem;

/// NAME of `.NAME.PID.tmp` whose process is gone; empty otherwise.
std::string_view owner_gone(std::string_view file) {
    if (!file.starts_with('.') || !file.ends_with(".tmp")) return {};
    file = file.substr(1, file.size() - 5);
    const std::size_t dot = file.rfind('.');
    if (dot == std::string_view::npos) return {};
    const auto pid = base::parse_integer(file.substr(dot + 1));
    if (!pid || *pid < 1 || ::kill(static_cast<pid_t>(*pid), 0) == 0 || errno != ESRCH) return {};
    return file.substr(0, dot);
}

}  // namespace

void remove_leftovers(const Job& job, std::span<const std::size_t> items) {
    std::map<fs::path, std::set<std::string, std::less<>>> names;
    for (const std::size_t item : items) {
        const fs::path output = job.output_of(item);
        // As base::write_file_atomically() cuts it; side files begin with the same stem.
        names[output.parent_path()].insert(output.stem().string().substr(0, 200));
    }
    for (const auto& [folder, stems] : names) {
        std::error_code error;
        for (auto entry = fs::directory_iterator(folder.empty() ? "." : folder, error);
             !error && entry != fs::directory_iterator(); entry.increment(error)) {
            const std::string file = entry->path().filename().string();
            const std::string_view name = owner_gone(file);
            if (name.empty()) continue;
            std::string_view stem = name;
            bool is_ours = stems.contains(stem);
            for (std::size_t dot = 0; !is_ours && (dot = stem.rfind('.')) != stem.npos;) {
                stem = stem.substr(0, dot);
                is_ours = stems.contains(stem);
            }
            std::error_code ignored;
            if (is_ours) fs::remove(entry->path(), ignored);
        }
    }
}

}  // namespace facet::batch
