// glTF's JSON, read without trusting any type.
// SPDX-License-Identifier: MIT
#include "scene/gltf/json.h"

#include "base/json.h"

#include <spdlog/fmt/fmt.h>

#include <limits>
#include <vector>

namespace facet::scene::gltf {
std::string Pointer::text() const {
    std::vector<const Pointer*> parts;
    for (const Pointer* p = this; p->parent_ != nullptr; p = p->parent_) parts.push_back(p);
    std::string out;
    for (auto it = parts.rbegin(); it != parts.rend(); ++it) {
        out += '/';
        out += (*it)->key_.data() != nullptr ? base::pointer_key((*it)->key_)
                                             : std::to_string((*it)->index_);
    }
    return out;
}

std::string pointer_text(std::string_view array, std::size_t index, std::string_view rest) {
    return fmt::format("/{}/{}{}", array, index, rest);
}

const Json* find(const Json& object, std::string_view key) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

const Json* find_path(const Json& object, std::string_view path) {
    const Json* at = &object;
    while (at != nullptr && !path.empty()) {
        const std::size_t slash = path.find('/');
        at = find(*at, path.substr(0, slash));
        path = slash == std::string_view::npos ? std::string_view{} : path.substr(slash + 1);
    }
    return at;
}

std::optional<std::uint64_t> as_unsigned(const Json& value) {
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    if (value.is_number_integer() && value.get<std::int64_t>() >= 0)
        return value.get<std::uint64_t>();
    return std::nullopt;
}

std::optional<std::uint64_t> unsigned_at(const Json& object, std::string_view key) {
    const Json* const value = find(object, key);
    return value == nullptr ? std::nullopt : as_unsigned(*value);
}

std::optional<std::uint32_t> index_at(const Json& object, std::string_view key) {
    const auto value = unsigned_at(object, key);
    if (!value || *value > std::numeric_limits<std::int32_t>::max()) return std::nullopt;
    return static_cast<std::uint32_t>(*value);
}

std::optional<double> number_at(const Json& object, std::string_view key) {
    const Json* const value = find(object, key);
    if (value == nullptr || !value->is_number()) return std::nullopt;
    return value->get<double>();
}

std::optional<bool> bool_at(const Json& object, std::string_view key) {
    const Json* const value = find(object, key);
    if (value == nullptr || !value->is_boolean()) return std::nullopt;
    return value->get<bool>();
}

std::string string_at(const Json& object, std::string_view key) {
    const Json* const value = find(object, key);
    return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

std::size_t count_at(const Json& object, std::string_view key) {
    const Json* const value = find(object, key);
    return value != nullptr && value->is_array() ? value->size() : 0;
}

const Json* element_at(const Json& object, std::string_view key, std::size_t index) {
    return index < count_at(object, key) ? &(*find(object, key))[index] : nullptr;
}

std::string brief(const Json& value) {
    if (value.is_array()) return "an array";
    if (value.is_object()) return "an object";
    return value.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 80);
}

}  // namespace facet::scene::gltf
