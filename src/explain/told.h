// An explanation as a person reads it, and as a program does.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/texts.h"
#include "explain/explain.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace facet::explain {

/// Lines of a tree, the last with its line feed.
[[nodiscard]] std::string tree_of(const Explained& explained, const Pixel& pixel,
                                  const base::Texts& texts);

/// One object, with every sample. docs/explain.md names its members.
[[nodiscard]] nlohmann::ordered_json json_of(const Explained& explained, const Pixel& pixel);

/// What the object of an id is called, and the material's and light's index in the scene.
[[nodiscard]] std::string object_name(const scene::Scene& scene, std::uint32_t object_id);
[[nodiscard]] const scene::Light& light_of(const scene::Scene& scene,
                                           const shared::ExplainedLight& light);

}  // namespace facet::explain
