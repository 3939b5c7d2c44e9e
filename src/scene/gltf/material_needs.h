// What a material asks of the primitives that wear it: texture coordinates and tangents.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/json.h"
#include "scene/gltf/problems.h"

#include <cstdint>
#include <string>
#include <vector>

namespace facet::scene::gltf {

/// A textureInfo of a material, wherever it stands.
struct Binding {
    std::string path;
    std::uint64_t set = 0;  ///< of texture coordinates
};

struct MaterialNeeds {
    std::vector<Binding> bindings;
    bool has_normal_map = false;
    bool has_tangent_lobes = false;  ///< anisotropy, or a normal map of the clear coat
};

/// By material, read once: a million primitives may wear the same one.
[[nodiscard]] std::vector<MaterialNeeds> read_material_needs(const Json& json);

/// The primitive at `where` against its material.
void check_material_needs(const std::vector<MaterialNeeds>& needs, const Json& primitive,
                          const std::string& where, Problems& problems);
/// The primitive's KHR_materials_variants mappings.
void check_mappings(const Json& json, const Json& primitive, const std::string& where,
                    Problems& problems);

}  // namespace facet::scene::gltf
