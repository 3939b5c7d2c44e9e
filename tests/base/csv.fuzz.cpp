// The CSV reader on hostile bytes: it ends, keeps within the text, and reads back what was written.
// SPDX-License-Identifier: MIT
#include "base/csv.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace facet::base {
namespace {

constexpr std::string_view seeds[] = {
    "a,b\n1,2\n", "\"x\"\"y\",\"\n\",,\r\n", "\xEF\xBB\xBF\"", "\"\"\"\"\"", ",\n,\r,\"", "\"a\"b"};

/// Reads to the end or the first error; the bytes of all fields together.
std::size_t read_all(std::string_view text) {
    CsvReader reader(text);
    CsvRecord record;
    std::size_t bytes = 0;
    for (std::size_t records = 0; records <= text.size() + 1; ++records) {
        const auto more = reader.next(record);
        if (!more || !*more) return bytes;
        for (const std::string& field : record.fields) bytes += field.size();
        EXPECT_LE(record.line, text.size() + 1);
    }
    ADD_FAILURE() << "more records than bytes";
    return bytes;
}

TEST(CsvFuzz, EndsOnEveryMutationWithNoMoreBytesThanItWasGiven) {
    std::mt19937 random(1);
    const std::string_view alphabet = "\",\r\n a1\0\xFF";
    for (int round = 0; round < 20'000; ++round) {
        std::string text(seeds[random() % std::size(seeds)]);
        for (std::uint_fast32_t edits = random() % 8; edits > 0; --edits) {
            const char byte = alphabet[random() % alphabet.size()];
            const std::size_t at = text.empty() ? 0 : random() % text.size();
            if (text.empty() || random() % 2 == 0)
                text.insert(at, 1, byte);
            else
                text[at] = byte;
        }
        ASSERT_LE(read_all(text), text.size());
    }
}

TEST(CsvFuzz, ReadsBackWhateverFieldsWereWritten) {
    std::mt19937 random(2);
    for (int round = 0; round < 5'000; ++round) {
        std::vector<std::string> fields(1 + random() % 4);
        std::string line;
        for (std::size_t i = 0; i < fields.size(); ++i) {
            for (std::uint_fast32_t length = random() % 6; length > 0; --length)
                fields[i] += static_cast<char>(" ,\"\n\rab"[random() % 7]);
            line += (i == 0 ? "" : ",") + csv_field(fields[i]);
        }
        if (line.empty() || line.find_first_not_of("\r\n") == std::string::npos)
            continue;  // an empty line is none
        CsvReader reader(line);
        CsvRecord record;
        const auto more = reader.next(record);
        ASSERT_TRUE(more && *more) << line;
        // A carriage return in front disarms as a formula would.
        for (std::string& field : fields)
            if (field.starts_with('\r')) field.insert(0, "'");
        ASSERT_EQ(record.fields, fields) << line;
    }
}

}  // namespace
}  // namespace facet::base
