// What a picture depends on, as one hash: a later run redoes an item only where this changed.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "batch/job.h"

#include <string>
#include <unordered_map>

namespace facet::batch {

/// Hashes of inputs; every file is read once in its life.
class InputHashes {
public:
    explicit InputHashes(base::Limits limits) : limits_(limits) {}

    /// SHA-256 of the item's settings and sequence, and of the contents of its
    /// scene, environment, textures and presets. A file that cannot be read counts as that.
    [[nodiscard]] std::string of(const Job& job, const Item& item);

private:
    const std::string& of_scene(const Item& item);
    const std::string& of_file(const std::string& path);

    base::Limits limits_;
    std::unordered_map<std::string, std::string> known_;
};

}  // namespace facet::batch
