// What of glTF this build does: the table, less the codecs that it was built without.
// SPDX-License-Identifier: MIT
#include "tables/gltf_features.h"

#include <algorithm>

namespace facet::tables {
namespace {

#ifdef FACET_HAS_MESHOPT
constexpr bool has_meshopt = true;
#else
constexpr bool has_meshopt = false;
#endif
#ifdef FACET_HAS_DRACO
constexpr bool has_draco = true;
#else
constexpr bool has_draco = false;
#endif

constexpr bool is_built(Codec codec) {
    return codec == Codec::none || (codec == Codec::meshopt && has_meshopt) ||
           (codec == Codec::draco && has_draco);
}

constexpr auto built_features = [] {
    auto rows = gltf_feature_rows::all;
    for (GltfFeature& row : rows)
        if (!is_built(row.codec)) row = {.name = row.name, .loss = row.loss, .codec = row.codec};
    return rows;
}();

}  // namespace

bool has_codec(Codec codec) { return is_built(codec); }

std::span<const GltfFeature> gltf_features() { return built_features; }

const GltfFeature* gltf_feature(std::string_view name) {
    const auto found = std::ranges::find(built_features, name, &GltfFeature::name);
    return found == built_features.end() ? nullptr : &*found;
}

}  // namespace facet::tables
