// Names of outputs, made from a text with placeholders.
// SPDX-License-Identifier: MIT
#include "batch/name_template.h"

#include "base/text.h"

#include <algorithm>

namespace facet::batch {
namespace {

constexpr std::size_t longest_name = 100;  // a folder's and a file's limit is 255
constexpr long long widest = 20;

tl::unexpected<base::Error> refuse(std::string what, std::string_view found, std::string remedy) {
    return base::fail({.code = base::ErrorCode::usage,
                       .what = std::move(what),
                       .found = std::string(found),
                       .remedy = std::move(remedy)});
}

}  // namespace

base::Result<NameTemplate> NameTemplate::parse(std::string_view text,
                                               std::span<const std::string> known) {
    NameTemplate out;
    if (text.empty() || text.find('\0') != std::string_view::npos)
        return refuse("not a file name", text, "as out/{scene}-{index:05}.png");
    while (!text.empty()) {
        const std::size_t open = text.find_first_of("{}");
        if (open > 0) out.pieces_.push_back({.text = std::string(text.substr(0, open))});
        if (open == std::string_view::npos) break;
        const std::size_t close = text.find('}', open);
        if (text[open] == '}' || close == std::string_view::npos)
            return refuse("a brace without its partner", text.substr(open),
                          "placeholders are written {scene}");
        const std::string_view inside = text.substr(open + 1, close - open - 1);
        // A path of --set may hold anything; a width is what follows the last colon.
        const std::size_t colon = inside.rfind(':');
        Piece piece{.text = std::string(inside.substr(0, colon)), .is_key = true};
        if (colon != std::string_view::npos) {
            const auto width = base::parse_integer(inside.substr(colon + 1));
            if (!width || *width < 1 || *width > widest)
                return refuse("not a width of a placeholder", inside, "as {index:05}");
            piece.width = static_cast<std::size_t>(*width);
        }
        if (std::ranges::find(known, piece.text) == known.end())
            return refuse("no such placeholder", piece.text, base::suggestion(piece.text, known));
        out.pieces_.push_back(std::move(piece));
        text.remove_prefix(close + 1);
    }
    return out;
}

std::string NameTemplate::expand(const Labels& labels) const {
    std::string out;
    for (const Piece& piece : pieces_) {
        if (!piece.is_key) {
            out += piece.text;
            continue;
        }
        const std::string name = safe_name(labels(piece.text));
        if (name.size() < piece.width) out.append(piece.width - name.size(), '0');
        out += name;
    }
    return out;
}

std::string NameTemplate::sequence(const Labels& labels, std::string_view counter) const {
    std::string out;
    for (const Piece& piece : pieces_) {
        if (piece.is_key && piece.text == counter) {
            out += piece.width > 0 ? "%0" + std::to_string(piece.width) + "d" : "%d";
            continue;
        }
        NameTemplate one;
        one.pieces_ = {piece};
        for (const char c : one.expand(labels)) out += c == '%' ? "%%" : std::string(1, c);
    }
    return out;
}

bool NameTemplate::uses(std::string_view key) const {
    return std::ranges::any_of(
        pieces_, [&](const Piece& piece) { return piece.is_key && piece.text == key; });
}

std::string safe_name(std::string_view text) {
    std::string out;
    for (const char c : text.substr(0, longest_name)) {
        const auto code = static_cast<unsigned char>(c);
        const bool is_safe = code >= 0x20 && code != 0x7F &&
                             std::string_view("/\\:*?\"<>|").find(c) == std::string_view::npos;
        out += is_safe ? c : '_';
    }
    // Not in the middle of a letter.
    while (text.size() > longest_name && !out.empty() &&
           (static_cast<unsigned char>(text[out.size()]) & 0xC0U) == 0x80)
        out.pop_back();
    if (out.starts_with('.')) out.front() = '_';
    while (out.ends_with(' ') || out.ends_with('.')) out.pop_back();
    return out.empty() ? "_" : out;
}

}  // namespace facet::batch
