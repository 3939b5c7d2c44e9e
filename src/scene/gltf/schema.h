// The shape of glTF's JSON as tables, and the one walk that holds a document to them.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf/json.h"
#include "scene/gltf/problems.h"

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace facet::scene::gltf {

enum class Kind : std::uint8_t {
    any,
    boolean,
    integer,
    number,
    string,
    object,   ///< of `shape`
    objects,  ///< array of `shape`
    integers,
    numbers,
    strings,
    index_map,   ///< object of indices: attributes of a primitive
    index_maps,  ///< array of those: morph targets
};

[[nodiscard]] std::string_view kind_name(Kind kind);
[[nodiscard]] bool has_kind(const Json& value, Kind kind);
/// Of the elements of an array of this kind.
[[nodiscard]] Kind element_kind(Kind kind);
/// Whether `word` is one of "A|B|C".
[[nodiscard]] bool is_listed(std::string_view list, std::string_view word);

struct ObjectShape;

/// One property of an object. Indices are integers that refer to another array.
struct Rule {
    std::string_view name;
    Kind kind = Kind::any;
    bool is_required = false;
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool excludes_low = false;  ///< low itself is out
    bool excludes_high = false;
    std::string_view words = {};      ///< "A|B": the strings or integers allowed
    std::string_view lengths = {};    ///< "3|4": the array lengths allowed
    bool is_unique = false;           ///< no two elements alike
    std::string_view refers_to = {};  ///< path of the array that the index is into
    std::string_view needs = {};      ///< property that must stand beside
    const ObjectShape* shape = nullptr;
};

struct ObjectShape {
    std::string_view name;  ///< what extensions say they extend
    std::span<const Rule> rules;
    bool is_closed = true;  ///< no name, extensions and extras beyond the rules
};

/// An extension object: where it may stand and what is in it. No shape: nothing is known of it.
struct ExtensionRule {
    std::string_view name;
    std::string_view host;  ///< ObjectShape::name
    const ObjectShape* shape = nullptr;
};

[[nodiscard]] const ObjectShape& document_shape();
[[nodiscard]] std::span<const ExtensionRule> extension_rules();
/// Parts of the table, one file each.
[[nodiscard]] const ObjectShape& accessor_shape();
[[nodiscard]] const ObjectShape& buffer_shape();
[[nodiscard]] const ObjectShape& buffer_view_shape();
[[nodiscard]] const ObjectShape& mesh_shape();
[[nodiscard]] const ObjectShape& node_shape();
[[nodiscard]] const ObjectShape& scene_shape();
[[nodiscard]] const ObjectShape& skin_shape();
[[nodiscard]] const ObjectShape& camera_shape();
[[nodiscard]] const ObjectShape& animation_shape();
[[nodiscard]] const ObjectShape& material_shape();
[[nodiscard]] const ObjectShape& texture_info_shape();
[[nodiscard]] const ObjectShape& normal_texture_info_shape();
[[nodiscard]] const ObjectShape& texture_shape();
[[nodiscard]] const ObjectShape& image_shape();
[[nodiscard]] const ObjectShape& sampler_shape();
[[nodiscard]] const ObjectShape& draco_primitive_shape();
[[nodiscard]] const ObjectShape& meshopt_buffer_shape();
[[nodiscard]] const ObjectShape& ext_meshopt_view_shape();
[[nodiscard]] const ObjectShape& khr_meshopt_view_shape();

/// Adds every departure of `json` from the tables. Afterwards, where no error was added, every
/// property has the type that the table says and every index an element.
void check_schema(const Json& json, Problems& problems);

}  // namespace facet::scene::gltf
