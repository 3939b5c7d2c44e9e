// The vertex attributes glTF names, and the formats each may have.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/asset.h"

#include <optional>
#include <string>
#include <string_view>

namespace facet::scene::gltf {

/// A name split into semantic and set: "TEXCOORD_1" is TEXCOORD, 1.
struct AttributeName {
    std::string_view semantic;
    std::optional<std::size_t> set;
};
/// Nothing where the name is neither one of glTF's nor starts with an underscore.
[[nodiscard]] std::optional<AttributeName> parse_attribute(std::string_view name);

enum class Quantized { no, yes };  ///< KHR_mesh_quantization
/// "VEC3 f32|…"; empty where any format will do.
[[nodiscard]] std::string_view formats_of(std::string_view semantic, bool is_morph,
                                          Quantized quantized);
/// "VEC3 u8n": type, component, n where normalized.
[[nodiscard]] std::string format_of(const Accessor& accessor);

}  // namespace facet::scene::gltf
