// Shapes of the extension objects that describe compressed geometry.
// SPDX-License-Identifier: MIT
#include "scene/gltf/schema.h"

#include <array>

namespace facet::scene::gltf {
namespace {

constexpr double size_max = 9007199254740991.0;  // 2^53 - 1

constexpr auto meshopt_view(std::string_view filters) {
    return std::to_array<Rule>(
        {{.name = "buffer", .kind = Kind::integer, .is_required = true, .refers_to = "buffers"},
         {.name = "byteOffset", .kind = Kind::integer, .low = 0, .high = size_max},
         {.name = "byteLength",
          .kind = Kind::integer,
          .is_required = true,
          .low = 1,
          .high = size_max},
         {.name = "byteStride", .kind = Kind::integer, .is_required = true, .low = 2, .high = 256},
         {.name = "count", .kind = Kind::integer, .is_required = true, .low = 1, .high = size_max},
         {.name = "mode",
          .kind = Kind::string,
          .is_required = true,
          .words = "ATTRIBUTES|TRIANGLES|INDICES"},
         {.name = "filter", .kind = Kind::string, .words = filters}});
}
constexpr auto ext_rules = meshopt_view("NONE|OCTAHEDRAL|QUATERNION|EXPONENTIAL");
constexpr auto khr_rules = meshopt_view("NONE|OCTAHEDRAL|QUATERNION|EXPONENTIAL|COLOR");
constexpr ObjectShape ext_view{.name = "meshoptView", .rules = ext_rules};
constexpr ObjectShape khr_view{.name = "meshoptView", .rules = khr_rules};

constexpr auto meshopt_buffer_rules =
    std::to_array<Rule>({{.name = "fallback", .kind = Kind::boolean}});
constexpr ObjectShape meshopt_buffer{.name = "meshoptBuffer", .rules = meshopt_buffer_rules};

// Ids within the stream, under any attribute's name.
constexpr ObjectShape draco_attributes{.name = "dracoAttributes", .rules = {}, .is_closed = false};
constexpr auto draco_rules = std::to_array<Rule>(
    {{.name = "bufferView", .kind = Kind::integer, .is_required = true, .refers_to = "bufferViews"},
     {.name = "attributes",
      .kind = Kind::object,
      .is_required = true,
      .shape = &draco_attributes}});
constexpr ObjectShape draco_primitive{.name = "dracoPrimitive", .rules = draco_rules};

}  // namespace

const ObjectShape& draco_primitive_shape() { return draco_primitive; }
const ObjectShape& meshopt_buffer_shape() { return meshopt_buffer; }
const ObjectShape& ext_meshopt_view_shape() { return ext_view; }
const ObjectShape& khr_meshopt_view_shape() { return khr_view; }

}  // namespace facet::scene::gltf
