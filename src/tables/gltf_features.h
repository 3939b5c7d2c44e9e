// What of glTF this renderer does: gltf_features.def's expansion.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace facet::tables {

enum class Support : std::uint8_t { no, yes };
/// What a build may lack (cmake/dependencies.cmake).
enum class Codec : std::uint8_t { none, meshopt, draco };
constexpr std::string_view name_of(Support support) {
    return support == Support::yes ? "yes" : "no";
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
    Codec codec = Codec::none;   ///< that it needs; `no` throughout in a build without
};
namespace gltf_feature_rows {
using enum Support;
using enum Codec;
inline constexpr auto all = std::to_array<GltfFeature>({
#define GLTF_FEATURE(key, ...) {.name = key, __VA_ARGS__},
#include "tables/gltf_features.def"
});
}  // namespace gltf_feature_rows

/// Whether this build has `codec`.
[[nodiscard]] bool has_codec(Codec codec);
/// The table's rows, as this build keeps to them.
[[nodiscard]] std::span<const GltfFeature> gltf_features();
/// Null where the table has no such row.
[[nodiscard]] const GltfFeature* gltf_feature(std::string_view name);

}  // namespace facet::tables
