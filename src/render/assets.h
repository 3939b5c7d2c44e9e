// What several pictures share, read and decoded once.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/lru_cache.h"
#include "scene/environment.h"
#include "scene/load.h"

#include <memory>
#include <string>

namespace facet::render {

/// Scenes and environments by name, as long as their files stay the same and the bound allows. Safe
/// to use from several threads.
class Assets {
public:
    explicit Assets(std::size_t max_bytes) : scenes_(max_bytes), environments_(max_bytes) {}

    /// As scene::load().
    [[nodiscard]] base::Result<std::shared_ptr<const scene::Loaded>> scene(
        const std::string& name, const scene::LoadOptions& options, const base::Limits& limits,
        base::ThreadPool& pool);

    struct LoadedEnvironment {
        scene::Environment environment;
        base::Warnings warnings;
    };
    /// As scene::load_environment().
    [[nodiscard]] base::Result<std::shared_ptr<const LoadedEnvironment>> environment(
        const std::string& spec, const base::Limits& limits, base::ThreadPool& pool);

private:
    base::LruCache<scene::Loaded> scenes_;
    base::LruCache<LoadedEnvironment> environments_;
};

}  // namespace facet::render
