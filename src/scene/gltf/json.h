// glTF's JSON, read without trusting any type.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace facet::scene::gltf {

using Json = nlohmann::json;

/// A place in the document, linked on the stack, so that its text is only made when it is printed.
class Pointer {
public:
    Pointer() = default;
    [[nodiscard]] Pointer operator/(std::string_view key) const { return Pointer(this, key, 0); }
    [[nodiscard]] Pointer operator/(std::size_t index) const { return Pointer(this, {}, index); }
    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::size_t depth() const noexcept {
        return parent_ == nullptr ? 0 : parent_->depth() + 1;
    }

private:
    Pointer(const Pointer* parent, std::string_view key, std::size_t index)
        : parent_(parent), key_(key), index_(index) {}
    const Pointer* parent_ = nullptr;
    std::string_view key_;  ///< empty data pointer: an index
    std::size_t index_ = 0;
};
/// "/a/1/b" from its parts.
[[nodiscard]] std::string pointer_text(std::string_view array, std::size_t index,
                                       std::string_view rest = {});

/// The member, or null where `object` is no object or has none.
[[nodiscard]] const Json* find(const Json& object, std::string_view key);
/// Follows "a/b/c" through objects.
[[nodiscard]] const Json* find_path(const Json& object, std::string_view path);
[[nodiscard]] std::optional<std::uint64_t> unsigned_at(const Json& object, std::string_view key);
/// A whole number that is no larger than 32 bits of sign: what indices are.
[[nodiscard]] std::optional<std::uint32_t> index_at(const Json& object, std::string_view key);
[[nodiscard]] std::optional<double> number_at(const Json& object, std::string_view key);
[[nodiscard]] std::optional<bool> bool_at(const Json& object, std::string_view key);
[[nodiscard]] std::string string_at(const Json& object, std::string_view key);
/// Elements of the array `key`; 0 where it is no array.
[[nodiscard]] std::size_t count_at(const Json& object, std::string_view key);
/// Element `index` of the array `key`; null where there is none.
[[nodiscard]] const Json* element_at(const Json& object, std::string_view key, std::size_t index);
/// A whole number not below 0.
[[nodiscard]] std::optional<std::uint64_t> as_unsigned(const Json& value);
/// What `value` is, short enough to print.
[[nodiscard]] std::string brief(const Json& value);

}  // namespace facet::scene::gltf
