// Shapes of materials, textures, images and samplers (glTF 2.0, chapter 5).
// SPDX-License-Identifier: MIT
#include "scene/gltf/schema.h"

#include <array>

namespace facet::scene::gltf {
namespace {

constexpr auto texture_info_rules = std::to_array<Rule>(
    {{.name = "index", .kind = Kind::integer, .is_required = true, .refers_to = "textures"},
     {.name = "texCoord", .kind = Kind::integer, .low = 0}});
constexpr ObjectShape texture_info{.name = "textureInfo", .rules = texture_info_rules};

constexpr auto normal_info_rules = std::to_array<Rule>(
    {{.name = "index", .kind = Kind::integer, .is_required = true, .refers_to = "textures"},
     {.name = "texCoord", .kind = Kind::integer, .low = 0},
     {.name = "scale", .kind = Kind::number}});
constexpr ObjectShape normal_info{.name = "textureInfo", .rules = normal_info_rules};

constexpr auto occlusion_info_rules = std::to_array<Rule>(
    {{.name = "index", .kind = Kind::integer, .is_required = true, .refers_to = "textures"},
     {.name = "texCoord", .kind = Kind::integer, .low = 0},
     {.name = "strength", .kind = Kind::number, .low = 0, .high = 1}});
constexpr ObjectShape occlusion_info{.name = "textureInfo", .rules = occlusion_info_rules};

constexpr auto pbr_rules = std::to_array<Rule>(
    {{.name = "baseColorFactor", .kind = Kind::numbers, .low = 0, .high = 1, .lengths = "4"},
     {.name = "baseColorTexture", .kind = Kind::object, .shape = &texture_info},
     {.name = "metallicFactor", .kind = Kind::number, .low = 0, .high = 1},
     {.name = "roughnessFactor", .kind = Kind::number, .low = 0, .high = 1},
     {.name = "metallicRoughnessTexture", .kind = Kind::object, .shape = &texture_info}});
constexpr ObjectShape pbr{.name = "pbrMetallicRoughness", .rules = pbr_rules};

constexpr auto material_rules = std::to_array<Rule>(
    {{.name = "pbrMetallicRoughness", .kind = Kind::object, .shape = &pbr},
     {.name = "normalTexture", .kind = Kind::object, .shape = &normal_info},
     {.name = "occlusionTexture", .kind = Kind::object, .shape = &occlusion_info},
     {.name = "emissiveTexture", .kind = Kind::object, .shape = &texture_info},
     {.name = "emissiveFactor", .kind = Kind::numbers, .low = 0, .high = 1, .lengths = "3"},
     {.name = "alphaMode", .kind = Kind::string, .words = "OPAQUE|MASK|BLEND"},
     {.name = "alphaCutoff", .kind = Kind::number, .low = 0},
     {.name = "doubleSided", .kind = Kind::boolean}});
constexpr ObjectShape material{.name = "material", .rules = material_rules};

constexpr auto texture_rules =
    std::to_array<Rule>({{.name = "sampler", .kind = Kind::integer, .refers_to = "samplers"},
                         {.name = "source", .kind = Kind::integer, .refers_to = "images"}});
constexpr ObjectShape texture{.name = "texture", .rules = texture_rules};

constexpr auto image_rules = std::to_array<Rule>({{.name = "uri", .kind = Kind::string},
                                                  {.name = "mimeType", .kind = Kind::string},
                                                  {.name = "bufferView",
                                                   .kind = Kind::integer,
                                                   .refers_to = "bufferViews",
                                                   .needs = "mimeType"}});
constexpr ObjectShape image{.name = "image", .rules = image_rules};

constexpr auto sampler_rules = std::to_array<Rule>(
    {{.name = "magFilter", .kind = Kind::integer, .words = "9728|9729"},
     {.name = "minFilter", .kind = Kind::integer, .words = "9728|9729|9984|9985|9986|9987"},
     {.name = "wrapS", .kind = Kind::integer, .words = "33071|33648|10497"},
     {.name = "wrapT", .kind = Kind::integer, .words = "33071|33648|10497"}});
constexpr ObjectShape sampler{.name = "sampler", .rules = sampler_rules};

}  // namespace

const ObjectShape& material_shape() { return material; }
const ObjectShape& texture_info_shape() { return texture_info; }
const ObjectShape& normal_texture_info_shape() { return normal_info; }
const ObjectShape& texture_shape() { return texture; }
const ObjectShape& image_shape() { return image; }
const ObjectShape& sampler_shape() { return sampler; }

}  // namespace facet::scene::gltf
