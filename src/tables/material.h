// The numbers and textures of a material: material.def's and material_textures.def's only
// expansion. SPDX-License-Identifier: MIT
#pragma once

#include "math/vector.h"
#include "tables/describe.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>

namespace facet::tables {

using Color = math::Vec3;

/// Parts of the BRDF that a material need not have; base: all have it.
enum class Lobe : std::uint8_t {
    base,
#define LOBE(name, ...) name,
#include "tables/lobes.def"
};
/// One row of lobes.def.
struct MaterialLobe {
    std::string_view key;
    Lobe lobe;
    bool is_layer = false;
};
inline constexpr auto material_lobes = std::to_array<MaterialLobe>({
#define LOBE(name, ...) {.key = #name, .lobe = Lobe::name, __VA_ARGS__},
#include "tables/lobes.def"
});

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
    Lobe lobe = Lobe::base;  ///< that reads it
    std::string_view gltf;   ///< JSON pointer below the material
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
    bool is_ramp = false;        ///< looked up by an angle: it asks for no coordinates
    bool is_relief = false;      ///< moves vertices: no shading reads it
    Lobe lobe = Lobe::base;      ///< that reads it
    std::string_view gltf;       ///< JSON pointer of the textureInfo below the material
    std::string_view help;
};
inline constexpr auto material_textures = std::to_array<MaterialTexture>({
#define TEXTURE(name, ...) {.key = #name, __VA_ARGS__},
#include "tables/material_textures.def"
});

/// What the texels of a map are, which says how they are averaged. One image may be used as
/// several.
enum class Texels : std::uint8_t { numbers, colors, normals };
inline constexpr std::size_t texels_count = 3;
[[nodiscard]] constexpr Texels texels_of(const MaterialTexture& row) {
    if (row.is_normal_map) return Texels::normals;
    return row.space == Space::srgb ? Texels::colors : Texels::numbers;
}

}  // namespace facet::tables
