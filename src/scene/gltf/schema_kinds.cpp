// The kinds of values that the tables of shapes speak of.
// SPDX-License-Identifier: MIT
#include "scene/gltf/schema.h"

#include <algorithm>

namespace facet::scene::gltf {

bool is_listed(std::string_view list, std::string_view word) {
    for (std::size_t start = 0; start <= list.size();) {
        const std::size_t end = std::min(list.find('|', start), list.size());
        if (list.substr(start, end - start) == word) return true;
        start = end + 1;
    }
    return false;
}

std::string_view kind_name(Kind kind) {
    switch (kind) {
        case Kind::boolean:
            return "boolean";
        case Kind::integer:
            return "integer";
        case Kind::number:
            return "number";
        case Kind::string:
            return "string";
        case Kind::object:
        case Kind::index_map:
            return "object";
        case Kind::objects:
        case Kind::integers:
        case Kind::numbers:
        case Kind::strings:
        case Kind::index_maps:
            return "array";
        case Kind::any:
            break;
    }
    return "value";
}

bool has_kind(const Json& value, Kind kind) {
    switch (kind) {
        case Kind::boolean:
            return value.is_boolean();
        case Kind::integer:
            return value.is_number_integer();
        case Kind::number:
            return value.is_number();
        case Kind::string:
            return value.is_string();
        case Kind::object:
        case Kind::index_map:
            return value.is_object();
        case Kind::objects:
        case Kind::integers:
        case Kind::numbers:
        case Kind::strings:
        case Kind::index_maps:
            return value.is_array();
        case Kind::any:
            break;
    }
    return true;
}

Kind element_kind(Kind kind) {
    switch (kind) {
        case Kind::objects:
            return Kind::object;
        case Kind::integers:
            return Kind::integer;
        case Kind::numbers:
            return Kind::number;
        case Kind::strings:
            return Kind::string;
        case Kind::index_maps:
            return Kind::index_map;
        default:
            return Kind::any;
    }
}

}  // namespace facet::scene::gltf
