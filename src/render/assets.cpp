// What several pictures share, read and decoded once.
// SPDX-License-Identifier: MIT
#include "render/assets.h"

#include "base/text.h"

#include <spdlog/fmt/fmt.h>
#include <sys/stat.h>

namespace facet::render {
namespace {

/// Another text when the file became another one.
std::string stamp(const std::filesystem::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return "";
    return fmt::format("\n{} {} {}.{:09}", status.st_ino, status.st_size, status.st_mtim.tv_sec,
                       status.st_mtim.tv_nsec);
}

std::string key_of(const std::string& name, const scene::LoadOptions& options) {
    std::string key = name + stamp(name) + (options.strict ? "\nstrict" : "");
    return key + "\n" + base::join(options.ignored_required, ",") + "\n" + options.variant;
}

}  // namespace

base::Result<std::shared_ptr<const scene::Loaded>> Assets::scene(const std::string& name,
                                                                 const scene::LoadOptions& options,
                                                                 const base::Limits& limits,
                                                                 base::ThreadPool& pool) {
    const std::string key = key_of(name, options);
    if (auto known = scenes_.find(key)) return known;
    auto loaded = scene::load(name, options, limits, pool);
    if (!loaded) return tl::unexpected(loaded.error());
    auto shared = std::make_shared<const scene::Loaded>(std::move(*loaded));
    scenes_.put(key, shared, shared->scene.memory_bytes());
    return shared;
}

base::Result<std::shared_ptr<const Assets::LoadedEnvironment>> Assets::environment(
    const std::string& spec, const base::Limits& limits, base::ThreadPool& pool) {
    const std::string key = spec + stamp(spec);
    if (auto known = environments_.find(key)) return known;
    LoadedEnvironment loaded;
    auto environment = scene::load_environment(spec, limits, pool, loaded.warnings);
    if (!environment) return tl::unexpected(environment.error());
    loaded.environment = std::move(*environment);
    auto shared = std::make_shared<const LoadedEnvironment>(std::move(loaded));
    environments_.put(key, shared, shared->environment.latlong->bytes.size());
    return shared;
}

}  // namespace facet::render
