// Comma-separated values.
// SPDX-License-Identifier: MIT
#include "base/csv.h"

#include "base/text.h"

#include <fmt/format.h>

namespace facet::base {
namespace {

tl::unexpected<Error> broken(std::size_t line, const char* what) {
    return fail(
        {.code = ErrorCode::input_invalid, .where = fmt::format("line {}", line), .what = what});
}

}  // namespace

CsvReader::CsvReader(std::string_view text) : text_(text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

Result<std::string> CsvReader::field() {
    std::string out;
    if (at_ >= text_.size() || text_[at_] != '"') {
        const std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
        out = text_.substr(at_, end - at_);
        at_ = end;
        return out;
    }
    const std::size_t first_line = line_;
    for (++at_; at_ < text_.size(); ++at_) {
        if (text_[at_] == '\n') ++line_;
        if (text_[at_] != '"') {
            out += text_[at_];
            continue;
        }
        ++at_;
        if (at_ < text_.size() && text_[at_] == '"') {
            out += '"';
            continue;
        }
        if (at_ < text_.size() &&
            std::string_view(",\r\n").find(text_[at_]) == std::string_view::npos)
            return broken(line_, "text behind a closing quote");
        return out;
    }
    return broken(first_line, "a quote that is not closed");
}

Result<bool> CsvReader::next(CsvRecord& record) {
    while (at_ < text_.size() && (text_[at_] == '\n' || text_[at_] == '\r'))
        line_ += text_[at_++] == '\n' ? 1 : 0;
    if (at_ >= text_.size()) return false;
    record.fields.clear();
    record.line = line_;
    for (;;) {
        auto value = field();
        if (!value) return tl::unexpected(value.error());
        record.fields.push_back(std::move(*value));
        if (at_ >= text_.size() || text_[at_] != ',') return true;
        ++at_;
    }
}

std::string csv_field(std::string_view text) {
    const bool is_formula = !text.empty() &&
                            std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos &&
                            !parse_number(text);
    std::string out = (is_formula ? "'" : "") + std::string(text);
    if (out.find_first_of(",\"\r\n") == std::string::npos) return out;
    std::string quoted = "\"";
    for (const char c : out) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

}  // namespace facet::base
