// Text helpers: printing what comes from files safely, and the nearest right names for a misspelt
// one. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facet::base {

/// `text` safe to print: control characters, bidirectional controls and invalid UTF-8 become \x..
/// or \u....; cut at `max_length` bytes with "...".
[[nodiscard]] std::string escaped(std::string_view text, std::size_t max_length = 120);

/// Text safe between tags and in attributes of HTML and SVG.
[[nodiscard]] std::string markup_escaped(std::string_view text);

/// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::string_view bytes);

/// Levenshtein distance, in bytes.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The names nearest to `name`, nearest first: edit distance at most 2 (3 for names over 8 bytes),
/// or a name that `name` is the beginning of. At most `most`.
[[nodiscard]] std::vector<std::string> nearest(std::string_view name,
                                               std::span<const std::string> names,
                                               std::size_t most = 3);

/// What to say of a name that is not among `names`: "did you mean A, B", or "there is A, B, C and 5
/// more" where nothing is near. Not escaped.
[[nodiscard]] std::string suggestion(std::string_view name, std::span<const std::string> names);

/// Pieces between separators; "a,,b" has three.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);
[[nodiscard]] std::string_view trimmed(std::string_view text);
[[nodiscard]] std::string join(std::span<const std::string> parts, std::string_view separator);

/// The whole text as one finite number, whatever the locale; nothing where it is anything else.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);
[[nodiscard]] std::optional<long long> parse_integer(std::string_view text);

}  // namespace facet::base
