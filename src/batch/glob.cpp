// Files by pattern.
// SPDX-License-Identifier: MIT
#include "batch/glob.h"

#include "base/text.h"

#include <fnmatch.h>

#include <algorithm>

namespace facet::batch {
namespace {

namespace fs = std::filesystem;

struct Search {
    std::vector<std::string> steps;
    std::vector<std::string> found;

    void in(const fs::path& folder, const std::string& written, std::size_t step) {
        const std::string& name = steps[step];
        const bool is_last = step + 1 == steps.size();
        if (name == "**") {
            if (is_last) return;
            in(folder, written, step + 1);
        } else if (!is_pattern(name)) {
            visit(folder / name, written + name, step, is_last);
            return;
        }
        std::error_code error;
        for (auto entry = fs::directory_iterator(folder.empty() ? "." : folder, error);
             !error && entry != fs::directory_iterator(); entry.increment(error)) {
            const std::string file = entry->path().filename().string();
            if (name == "**") {
                if (!file.starts_with('.') && entry->is_directory(error) &&
                    !entry->is_symlink(error))
                    in(entry->path(), written + file + "/", step);
            } else if (::fnmatch(name.c_str(), file.c_str(), FNM_PERIOD | FNM_NOESCAPE) == 0) {
                visit(entry->path(), written + file, step, is_last);
            }
        }
    }

    void visit(const fs::path& path, const std::string& written, std::size_t step, bool is_last) {
        std::error_code error;
        if (is_last) {
            if (fs::is_regular_file(path, error)) found.push_back(written);
        } else if (fs::is_directory(path, error)) {
            in(path, written + "/", step + 1);
        }
    }
};

}  // namespace

bool is_pattern(std::string_view text) { return text.find_first_of("*?[") != text.npos; }

std::vector<std::string> matching_files(const fs::path& folder, const std::string& pattern) {
    Search search;
    for (const std::string_view step : base::split(pattern, '/'))
        if (!step.empty()) search.steps.emplace_back(step);
    if (search.steps.empty()) return {};
    const bool is_absolute = pattern.starts_with('/');
    search.in(is_absolute ? fs::path("/") : folder, is_absolute ? "/" : "", 0);
    std::ranges::sort(search.found);
    const auto repeated = std::ranges::unique(search.found);
    search.found.erase(repeated.begin(), repeated.end());
    return std::move(search.found);
}

}  // namespace facet::batch
