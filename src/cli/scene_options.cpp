// The settings that concern the reading of a scene.
// SPDX-License-Identifier: MIT
#include "cli/scene_options.h"

#include <algorithm>

namespace facet::cli {

bool concerns_loading(const tables::Setting& row) {
    constexpr std::string_view keys[] = {"allow_read", "ignore_required", "strict", "max_memory",
                                         "max_vertices"};
    return std::ranges::find(keys, row.key) != std::end(keys);
}

scene::LoadOptions load_options(const tables::Settings& settings) {
    scene::LoadOptions options;
    options.allowed_folders.assign(settings.allow_read.begin(), settings.allow_read.end());
    options.ignored_required = settings.ignore_required;
    if (!settings.base.empty()) options.base_folder = settings.base;
    options.decode_images = false;
    options.strict = settings.strict;
    return options;
}

base::Limits limits_of(const tables::Settings& settings) {
    base::Limits limits;
    if (settings.max_memory > 0) limits.memory_bytes = std::size_t{settings.max_memory} << 20;
    if (settings.max_vertices > 0) limits.vertices = settings.max_vertices;
    return limits;
}

}  // namespace facet::cli
