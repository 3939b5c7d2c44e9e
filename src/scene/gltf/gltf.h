// The glTF 2.0 importer, which trusts nothing in the file.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "base/limits.h"
#include "base/result.h"
#include "base/thread_pool.h"
#include "scene/gltf/asset.h"
#include "scene/load.h"

namespace facet::scene::gltf {

/// A scene from the bytes of a .gltf or .glb. The first problem of the checks that a picture would
/// suffer from is the error; the others become warnings. Errors: input_invalid, feature_missing (a
/// required extension), limit_reached.
[[nodiscard]] base::Result<Loaded> import_bytes(base::Bytes file, Origin origin,
                                                const LoadOptions& options,
                                                const base::Limits& limits, base::ThreadPool& pool);

/// Every problem, in order of the file's parts. Never fails: a file that is no glTF is one problem.
[[nodiscard]] std::vector<Finding> check_bytes(base::Bytes file, Origin origin,
                                               const base::Limits& limits);

/// SHA-256 of the file and of those that its buffers and images name; what cannot be read counts
/// as that. Nothing is decoded.
[[nodiscard]] std::string content_hash(base::Bytes file, Origin origin, const base::Limits& limits);

}  // namespace facet::scene::gltf
