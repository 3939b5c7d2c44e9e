// Where in a JSON text something stands: walked only for an error's sake.
// SPDX-License-Identifier: MIT
#include "base/json.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cctype>

namespace facet::base {
namespace {

/// A walk over a text that may be anything: every step is bounded by its end.
class Walk {
public:
    explicit Walk(std::string_view text) : text_(text) {}

    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] bool is_at(char c) const { return at_ < text_.size() && text_[at_] == c; }
    bool take(char c) {
        skip_space();
        if (!is_at(c)) return false;
        ++at_;
        return true;
    }
    void skip_space() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
            ++at_;
    }
    /// Over a text in quotes; what stands between them, as written.
    std::string_view skip_string() {
        const std::size_t begin = ++at_;
        while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
        const std::size_t end = std::min(at_, text_.size());
        at_ = std::min(at_ + 1, text_.size());
        return text_.substr(begin, end - begin);
    }
    void skip_value() {
        std::size_t depth = 0;
        skip_space();
        do {
            if (at_ >= text_.size()) return;
            const char c = text_[at_];
            if (c == '"') {
                skip_string();
                continue;
            }
            if (c == '{' || c == '[') ++depth;
            if (c == '}' || c == ']') {
                if (depth == 0) return;
                --depth;
            }
            if (depth == 0 && c == ',') return;
            ++at_;
        } while (true);
    }

private:
    std::string_view text_;
    std::size_t at_ = 0;
};

/// A key as written in the text against one of a pointer; escapes are read by the parser proper.
bool is_key(std::string_view written, std::string_view key) {
    if (written.find('\\') == std::string_view::npos) return written == key;
    const auto read = nlohmann::json::parse('"' + std::string(written) + '"', nullptr, false);
    return read.is_string() && read.get_ref<const std::string&>() == key;
}

std::string plain_key(std::string_view step) {
    std::string out;
    for (std::size_t i = 0; i < step.size(); ++i) {
        if (step[i] == '~' && i + 1 < step.size())
            out += step[++i] == '1' ? '/' : '~';
        else
            out += step[i];
    }
    return out;
}

/// Moves to the value of `key` in the object that begins here; where the key begins.
std::optional<std::size_t> enter_member(Walk& walk, std::string_view key, std::size_t occurrence) {
    if (!walk.take('{')) return std::nullopt;
    while (true) {
        walk.skip_space();
        if (!walk.is_at('"')) return std::nullopt;
        const std::size_t begin = walk.at();
        const bool found = is_key(walk.skip_string(), key);
        if (!walk.take(':')) return std::nullopt;
        if (found && occurrence-- == 0) return begin;
        walk.skip_value();
        if (!walk.take(',')) return std::nullopt;
    }
}

std::optional<std::size_t> enter_element(Walk& walk, std::string_view step) {
    const bool is_index = !step.empty() && step.size() < 10 &&
                          step.find_first_not_of("0123456789") == std::string_view::npos;
    if (!is_index || !walk.take('[')) return std::nullopt;
    for (std::size_t index = std::stoul(std::string(step)); index > 0; --index) {
        walk.skip_value();
        if (!walk.take(',')) return std::nullopt;
    }
    walk.skip_space();
    return walk.at();
}

TextPlace place_at(std::string_view text, std::size_t offset) {
    TextPlace place;
    for (const char c : text.substr(0, offset)) {
        ++place.column;
        if (c != '\n') continue;
        ++place.line;
        place.column = 1;
    }
    return place;
}

}  // namespace

std::string pointer_key(std::string_view key) {
    std::string out;
    for (const char c : key) {
        if (c == '~')
            out += "~0";
        else if (c == '/')
            out += "~1";
        else
            out += c;
    }
    return out;
}

std::optional<TextPlace> json_place(std::string_view text, std::string_view pointer,
                                    std::size_t occurrence) {
    Walk walk(text);
    walk.skip_space();
    std::size_t begin = walk.at();
    while (!pointer.empty()) {
        if (pointer.front() != '/') return std::nullopt;
        const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
        const std::string_view step = pointer.substr(1, end - 1);
        pointer.remove_prefix(end);
        walk.skip_space();
        const auto place =
            walk.is_at('{') ? enter_member(walk, plain_key(step), pointer.empty() ? occurrence : 0)
                            : enter_element(walk, step);
        if (!place) return std::nullopt;
        begin = *place;
    }
    return place_at(text, begin);
}

}  // namespace facet::base
