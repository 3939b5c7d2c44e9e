// JSON from outside, parsed within limits, and where in its text something stands.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace facet::base {

/// The document, with every limit held while it is read (no recursion: a nesting of 10^6 is an
/// error, not a stack overflow). Whole numbers written as floats (`1.0`) become integers. Keys are
/// unique. `Json` is nlohmann::json or nlohmann::ordered_json. Errors: input_invalid (syntax,
/// duplicate key, a number that fits nothing), limit_reached; `where` is a JSON pointer, a line and
/// column, or a byte offset.
template <class Json>
[[nodiscard]] Result<Json> parse_json(std::string_view text, const Limits& limits);

/// One step of a JSON pointer: RFC 6901 writes ~ and / inside a key as ~0 and ~1.
[[nodiscard]] std::string pointer_key(std::string_view key);

/// Where in `text` the key of the member, or the element, that a JSON pointer names begins; both
/// from 1, columns in bytes. `occurrence`: of a key that stands there more than once. None where
/// there is no such place.
struct TextPlace {
    std::size_t line = 1;
    std::size_t column = 1;
};
[[nodiscard]] std::optional<TextPlace> json_place(std::string_view text, std::string_view pointer,
                                                  std::size_t occurrence = 0);

}  // namespace facet::base
