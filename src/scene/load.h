// Loading a scene: from a file, from bytes, or one of the built-in ones.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"
#include "base/thread_pool.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace facet::scene {

struct LoadOptions {
    std::vector<std::filesystem::path> allowed_folders;  ///< --allow-read
    std::vector<std::string> ignored_required;           ///< --ignore-required
    std::optional<std::filesystem::path>
        base_folder;                           ///< --base: folder of relative URIs for bytes
    std::optional<std::uint32_t> scene_index;  ///< none: the file's default scene
    std::string variant;        ///< --variant: of KHR_materials_variants; empty: the file's default
    bool decode_images = true;  ///< off for `info`: headers are checked all the same
    bool strict = false;        ///< a missing texture is an error
};

/// A scene and what was wrong but usable in it.
struct Loaded {
    Scene scene;
    base::Warnings warnings;
    std::vector<std::filesystem::path> reads;  ///< every file opened, for --show-reads
};

/// `name` is a path, or "builtin:NAME" (a file of resources/scenes). Images are decoded on `pool`.
/// Errors: see docs of the importer; every error names the file.
[[nodiscard]] base::Result<Loaded> load(const std::string& name, const LoadOptions& options,
                                        const base::Limits& limits, base::ThreadPool& pool);
/// GLB or glTF text in memory (standard input).
[[nodiscard]] base::Result<Loaded> load_bytes(std::span<const std::byte> bytes,
                                              const std::string& label, const LoadOptions& options,
                                              const base::Limits& limits, base::ThreadPool& pool);

/// SHA-256 of all files that a scene consists of; cheap beside loading it. Errors: its own file
/// cannot be read.
[[nodiscard]] base::Result<std::string> content_hash(const std::string& name,
                                                     const LoadOptions& options,
                                                     const base::Limits& limits);

/// What files made of a scene are called, without an ending: of "-" it is "stdin".
[[nodiscard]] std::string stem_of(const std::string& name);

/// One finding of `facet check`, in the words and codes of the Khronos glTF-Validator.
struct Finding {
    enum class Severity { error, warning, information, hint };
    Severity severity = Severity::error;
    std::string code;
    std::string pointer;
    std::string message;
};
/// Every problem of a file. Errors (as a Result): only when the file cannot be read at all.
[[nodiscard]] base::Result<std::vector<Finding>> check(const std::string& path,
                                                       const LoadOptions& options,
                                                       const base::Limits& limits);

}  // namespace facet::scene
