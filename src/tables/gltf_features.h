// What of glTF this renderer does: gltf_features.def's expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace facet::tables {

enum class Support : std::uint8_t { no, drawn, yes };
constexpr std::string_view name_of(Support support) {
    constexpr std::string_view names[] = {"no", "drawn", "yes"};
    return names[static_cast<std::size_t>(support)];
}

/// One row of gltf_features.def.
struct GltfFeature {
    std::string_view name;  ///< of an extension, or words on a part of glTF 2.0
    Support loaded = Support::no;
    Support raster = Support::no;
    Support reference = Support::no;
    Support studio = Support::no;
    std::string_view test = {};  ///< a path in the sources
    std::string_view loss = {};  ///< what a picture lacks without it
};
namespace gltf_feature_rows {
using enum Support;
inline constexpr auto all = std::to_array<GltfFeature>({
#define GLTF_FEATURE(key, ...) {.name = key, __VA_ARGS__},
#include "tables/gltf_features.def"
});
}  // namespace gltf_feature_rows
inline constexpr const auto& gltf_features = gltf_feature_rows::all;

/// Null where the table has no such row.
constexpr const GltfFeature* gltf_feature(std::string_view name) {
    const auto found = std::ranges::find(gltf_features, name, &GltfFeature::name);
    return found == gltf_features.end() ? nullptr : &*found;
}

}  // namespace facet::tables
