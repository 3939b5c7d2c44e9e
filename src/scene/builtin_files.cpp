// Files that come with the program.
// SPDX-License-Identifier: MIT
#include "scene/builtin_files.h"

#include "base/resources.h"
#include "base/text.h"
#include "scene/scene.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <system_error>

namespace facet::scene {

namespace fs = std::filesystem;

std::vector<std::string> builtin_names(const BuiltinKind& kind) {
    std::vector<std::string> names;
    const auto data = base::data_folder();
    if (!data) return names;
    std::error_code error;
    for (fs::directory_iterator entry(*data / kind.folder, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->path().extension() == kind.ending)
            names.push_back(entry->path().stem().string());
    std::ranges::sort(names);
    return names;
}

base::Result<fs::path> file_of(const std::string& name, const BuiltinKind& kind) {
    if (!name.starts_with(builtin_prefix)) return fs::path(name);
    const auto data = base::data_folder();
    if (!data) return tl::unexpected(data.error());
    const std::string wanted = name.substr(builtin_prefix.size());
    const std::vector<std::string> names = builtin_names(kind);
    if (std::ranges::find(names, wanted) != names.end())
        return *data / kind.folder / (wanted + std::string(kind.ending));
    return base::fail({.code = base::ErrorCode::usage,
                       .file = name,
                       .what = fmt::format("no such built-in {}", kind.what),
                       .found = {},
                       .remedy = base::suggestion(wanted, names)});
}

}  // namespace facet::scene
