// Names of outputs, made from a text with placeholders: out/{scene}/{index:05}.png.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facet::batch {

/// What stands for a placeholder; not yet safe for a file name.
using Labels = std::function<std::string(std::string_view key)>;

class NameTemplate {
public:
    NameTemplate() = default;
    /// `known`: the keys there are. Errors: usage (an unknown placeholder with the nearest right
    /// ones, a width that is none, an open brace).
    [[nodiscard]] static base::Result<NameTemplate> parse(std::string_view text,
                                                          std::span<const std::string> known);
    /// Labels made safe as parts of file names; numbers padded where a width is given.
    [[nodiscard]] std::string expand(const Labels& labels) const;
    /// The same with `%d`, or `%05d`, where `counter` stands: what ffmpeg calls a sequence.
    [[nodiscard]] std::string sequence(const Labels& labels, std::string_view counter) const;
    [[nodiscard]] bool uses(std::string_view key) const;

private:
    struct Piece {
        std::string text;  ///< literal, or a key
        bool is_key = false;
        std::size_t width = 0;
    };
    std::vector<Piece> pieces_;
};

/// `text` as a part of a file name on any system: no separators, controls or leading dots, 100
/// bytes at most.
[[nodiscard]] std::string safe_name(std::string_view text);

}  // namespace facet::batch
