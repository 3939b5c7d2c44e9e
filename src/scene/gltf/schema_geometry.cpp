// Shapes of buffers, views, accessors, meshes and skins (glTF 2.0, chapter 5).
// SPDX-License-Identifier: MIT
#include "scene/gltf/schema.h"

#include <array>

namespace facet::scene::gltf {
namespace {

constexpr double int_max = 2147483647.0;
constexpr double size_max = 9007199254740991.0;  // 2^53 - 1

constexpr auto buffer_rules = std::to_array<Rule>({{.name = "uri", .kind = Kind::string},
                                                   {.name = "byteLength",
                                                    .kind = Kind::integer,
                                                    .is_required = true,
                                                    .low = 1,
                                                    .high = size_max}});
constexpr ObjectShape buffer{.name = "buffer", .rules = buffer_rules};

constexpr auto view_rules = std::to_array<Rule>(
    {{.name = "buffer", .kind = Kind::integer, .is_required = true, .refers_to = "buffers"},
     {.name = "byteOffset", .kind = Kind::integer, .low = 0, .high = size_max},
     {.name = "byteLength", .kind = Kind::integer, .is_required = true, .low = 1, .high = size_max},
     {.name = "byteStride", .kind = Kind::integer, .low = 4, .high = 252},
     {.name = "target", .kind = Kind::integer, .words = "34962|34963"}});
constexpr ObjectShape view{.name = "bufferView", .rules = view_rules};

constexpr auto sparse_index_rules = std::to_array<Rule>(
    {{.name = "bufferView", .kind = Kind::integer, .is_required = true, .refers_to = "bufferViews"},
     {.name = "byteOffset", .kind = Kind::integer, .low = 0, .high = int_max},
     {.name = "componentType",
      .kind = Kind::integer,
      .is_required = true,
      .words = "5121|5123|5125"}});
constexpr ObjectShape sparse_indices{.name = "accessorSparseIndices", .rules = sparse_index_rules};

constexpr auto sparse_value_rules = std::to_array<Rule>(
    {{.name = "bufferView", .kind = Kind::integer, .is_required = true, .refers_to = "bufferViews"},
     {.name = "byteOffset", .kind = Kind::integer, .low = 0, .high = int_max}});
constexpr ObjectShape sparse_values{.name = "accessorSparseValues", .rules = sparse_value_rules};

constexpr auto sparse_rules = std::to_array<Rule>(
    {{.name = "count", .kind = Kind::integer, .is_required = true, .low = 1, .high = int_max},
     {.name = "indices", .kind = Kind::object, .is_required = true, .shape = &sparse_indices},
     {.name = "values", .kind = Kind::object, .is_required = true, .shape = &sparse_values}});
constexpr ObjectShape sparse{.name = "accessorSparse", .rules = sparse_rules};

constexpr auto accessor_rules = std::to_array<Rule>(
    {{.name = "bufferView", .kind = Kind::integer, .refers_to = "bufferViews"},
     {.name = "byteOffset",
      .kind = Kind::integer,
      .low = 0,
      .high = size_max,
      .needs = "bufferView"},
     {.name = "componentType",
      .kind = Kind::integer,
      .is_required = true,
      .words = "5120|5121|5122|5123|5125|5126"},
     {.name = "normalized", .kind = Kind::boolean},
     {.name = "count", .kind = Kind::integer, .is_required = true, .low = 1, .high = size_max},
     {.name = "type",
      .kind = Kind::string,
      .is_required = true,
      .words = "SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4"},
     {.name = "max", .kind = Kind::numbers, .lengths = "1|2|3|4|9|16"},
     {.name = "min", .kind = Kind::numbers, .lengths = "1|2|3|4|9|16"},
     {.name = "sparse", .kind = Kind::object, .shape = &sparse}});
constexpr ObjectShape accessor{.name = "accessor", .rules = accessor_rules};

constexpr auto primitive_rules = std::to_array<Rule>(
    {{.name = "attributes", .kind = Kind::index_map, .is_required = true, .refers_to = "accessors"},
     {.name = "indices", .kind = Kind::integer, .refers_to = "accessors"},
     {.name = "material", .kind = Kind::integer, .refers_to = "materials"},
     {.name = "mode", .kind = Kind::integer, .words = "0|1|2|3|4|5|6"},
     {.name = "targets", .kind = Kind::index_maps, .refers_to = "accessors"}});
constexpr ObjectShape primitive{.name = "primitive", .rules = primitive_rules};

constexpr auto mesh_rules = std::to_array<Rule>(
    {{.name = "primitives", .kind = Kind::objects, .is_required = true, .shape = &primitive},
     {.name = "weights", .kind = Kind::numbers}});
constexpr ObjectShape mesh{.name = "mesh", .rules = mesh_rules};

constexpr auto skin_rules = std::to_array<Rule>(
    {{.name = "inverseBindMatrices", .kind = Kind::integer, .refers_to = "accessors"},
     {.name = "skeleton", .kind = Kind::integer, .refers_to = "nodes"},
     {.name = "joints",
      .kind = Kind::integers,
      .is_required = true,
      .is_unique = true,
      .refers_to = "nodes"}});
constexpr ObjectShape skin{.name = "skin", .rules = skin_rules};

}  // namespace

const ObjectShape& buffer_shape() { return buffer; }
const ObjectShape& buffer_view_shape() { return view; }
const ObjectShape& accessor_shape() { return accessor; }
const ObjectShape& mesh_shape() { return mesh; }
const ObjectShape& skin_shape() { return skin; }

}  // namespace facet::scene::gltf
