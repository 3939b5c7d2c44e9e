// The numbers and textures of a material: material.def's and material_textures.def's only
// expansion. SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"
#include "tables/describe.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <variant>

namespace facet::tables {

using Color = math::Vec3;

struct MaterialValues {
#define PARAM(type, name, initial, ...) type name = initial;
#include "tables/material.def"
};

/// One row of material.def.
struct MaterialParam {
    std::string_view key;
    std::variant<float MaterialValues::*, Color MaterialValues::*> field;
    Range range;
    Range slider{0, 0};        ///< what a slider spans, where that is less than `range`
    bool logarithmic = false;  ///< slider
    Space space = Space::none;
    std::string_view gltf;  ///< JSON pointer below the material
    std::string_view help;
};
inline constexpr auto material_params = std::to_array<MaterialParam>({
#define PARAM(type, name, initial, ...) {.key = #name, .field = &MaterialValues::name, __VA_ARGS__},
#include "tables/material.def"
});

/// Index of each texture of a material, in the order of material_textures.def.
enum class TextureSlot : std::size_t {
#define TEXTURE(name, ...) name,
#include "tables/material_textures.def"
};

/// One row of material_textures.def.
struct MaterialTexture {
    std::string_view key;
    Space space = Space::none;
    bool is_normal_map = false;  ///< asks for tangents, and nothing can stand in for it
    std::string_view gltf;       ///< JSON pointer of the textureInfo below the material
    std::string_view help;
};
inline constexpr auto material_textures = std::to_array<MaterialTexture>({
#define TEXTURE(name, ...) {.key = #name, __VA_ARGS__},
#include "tables/material_textures.def"
});

}  // namespace facet::tables
