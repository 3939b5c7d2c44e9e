// The vertex attributes glTF names, and KHR_mesh_quantization's formats of them.
// SPDX-License-Identifier: MIT
#include "scene/gltf/attributes.h"

#include <array>
#include <charconv>

namespace facet::scene::gltf {
namespace {

struct FormatRow {
    std::string_view semantic;
    bool is_morph;
    std::string_view plain;
    std::string_view quantized;  ///< allowed as well with the extension
};
constexpr auto format_rows = std::to_array<FormatRow>(
    {{"POSITION", false, "VEC3 f32",
      "VEC3 f32|VEC3 i8|VEC3 i8n|VEC3 u8|VEC3 u8n|VEC3 i16|VEC3 i16n|VEC3 u16|VEC3 u16n"},
     {"NORMAL", false, "VEC3 f32", "VEC3 f32|VEC3 i8n|VEC3 i16n"},
     {"TANGENT", false, "VEC4 f32", "VEC4 f32|VEC4 i8n|VEC4 i16n"},
     {"TEXCOORD", false, "VEC2 f32|VEC2 u8n|VEC2 u16n",
      "VEC2 f32|VEC2 u8n|VEC2 u16n|VEC2 i8|VEC2 i8n|VEC2 u8|VEC2 i16|VEC2 i16n|VEC2 u16"},
     {"COLOR", false, "VEC3 f32|VEC3 u8n|VEC3 u16n|VEC4 f32|VEC4 u8n|VEC4 u16n",
      "VEC3 f32|VEC3 u8n|VEC3 u16n|VEC4 f32|VEC4 u8n|VEC4 u16n"},
     {"JOINTS", false, "VEC4 u8|VEC4 u16", "VEC4 u8|VEC4 u16"},
     {"WEIGHTS", false, "VEC4 f32|VEC4 u8n|VEC4 u16n", "VEC4 f32|VEC4 u8n|VEC4 u16n"},
     {"POSITION", true, "VEC3 f32", "VEC3 f32|VEC3 i8|VEC3 i8n|VEC3 i16|VEC3 i16n"},
     {"NORMAL", true, "VEC3 f32", "VEC3 f32|VEC3 i8n|VEC3 i16n"},
     {"TANGENT", true, "VEC3 f32", "VEC3 f32|VEC3 i8n|VEC3 i16n"},
     {"TEXCOORD", true, "VEC2 f32|VEC2 u8n|VEC2 u16n|VEC2 i8n|VEC2 i16n",
      "VEC2 f32|VEC2 u8n|VEC2 u16n|VEC2 i8n|VEC2 i16n|VEC2 i8|VEC2 i16"},
     {"COLOR", true,
      "VEC3 f32|VEC3 u8n|VEC3 u16n|VEC3 i8n|VEC3 i16n|VEC4 f32|VEC4 u8n|VEC4 u16n|VEC4 i8n|VEC4 "
      "i16n",
      "VEC3 f32|VEC3 u8n|VEC3 u16n|VEC3 i8n|VEC3 i16n|VEC4 f32|VEC4 u8n|VEC4 u16n|VEC4 i8n|VEC4 "
      "i16n"}});

constexpr std::array<std::string_view, 3> plain_names{"POSITION", "NORMAL", "TANGENT"};
constexpr std::array<std::string_view, 4> numbered_names{"TEXCOORD", "COLOR", "JOINTS", "WEIGHTS"};

std::string_view component_name(Component component) {
    switch (component) {
        case Component::i8:
            return "i8";
        case Component::u8:
            return "u8";
        case Component::i16:
            return "i16";
        case Component::u16:
            return "u16";
        case Component::u32:
            return "u32";
        case Component::f32:
            return "f32";
    }
    return "?";
}

}  // namespace

std::optional<AttributeName> parse_attribute(std::string_view name) {
    if (name.starts_with('_')) return AttributeName{.semantic = "_", .set = {}};
    for (const std::string_view plain : plain_names)
        if (name == plain) return AttributeName{.semantic = plain, .set = {}};
    for (const std::string_view numbered : numbered_names) {
        if (!name.starts_with(numbered) || name.size() < numbered.size() + 2 ||
            name[numbered.size()] != '_')
            continue;
        const std::string_view digits = name.substr(numbered.size() + 1);
        if (digits.size() > 1 && digits[0] == '0') return std::nullopt;  // TEXCOORD_01
        std::size_t set = 0;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), set);
        if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
        return AttributeName{.semantic = numbered, .set = set};
    }
    return std::nullopt;
}

std::string_view formats_of(std::string_view semantic, bool is_morph, Quantized quantized) {
    for (const FormatRow& row : format_rows)
        if (row.semantic == semantic && row.is_morph == is_morph)
            return quantized == Quantized::yes ? row.quantized : row.plain;
    return {};
}

std::string format_of(const Accessor& accessor) {
    return accessor.type + " " + std::string(component_name(accessor.component)) +
           (accessor.is_normalized ? "n" : "");
}

}  // namespace facet::scene::gltf
