// Comma-separated values: RFC 4180.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace facet::base {

/// One record: its fields without quotes, and the line it begins at, from 1.
struct CsvRecord {
    std::vector<std::string> fields;
    std::size_t line = 0;
};

/// Reads `text` record by record. Lines end in LF or CRLF; empty ones are skipped.
class CsvReader {
public:
    explicit CsvReader(std::string_view text);
    /// False at the end. Errors: input_invalid, at `line N`: a quote that is not closed, text
    /// behind one.
    [[nodiscard]] Result<bool> next(CsvRecord& record);

private:
    [[nodiscard]] Result<std::string> field();
    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
};

/// A field as it is written: quoted where it must be. A text that a spreadsheet would take for a
/// formula gets a ' in front (faults, C16).
[[nodiscard]] std::string csv_field(std::string_view text);

}  // namespace facet::base
