// The glTF extensions this renderer knows, and what a picture loses without the others.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/json.h"
#include "scene/gltf/problems.h"
#include "scene/load.h"

#include <optional>
#include <string_view>

namespace facet::scene::gltf {

/// Whether the importer does what the extension says.
[[nodiscard]] bool is_implemented(std::string_view extension);
/// What is missing in the picture where `extension` is not implemented.
[[nodiscard]] std::string_view loss_without(std::string_view extension);

/// Errors: feature_missing for the first required extension that is neither implemented nor ignored
/// by `options`. Adds a warning for each one used and not implemented.
[[nodiscard]] base::Status check_implemented(const Json& json, const LoadOptions& options,
                                             base::Warnings& warnings);

}  // namespace facet::scene::gltf
