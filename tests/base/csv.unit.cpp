// CSV by RFC 4180, read and written.
// SPDX-License-Identifier: MIT
#include "base/csv.h"

#include <gtest/gtest.h>

namespace facet::base {
namespace {

using Records = std::vector<std::vector<std::string>>;

Records records(std::string_view text) {
    CsvReader reader(text);
    CsvRecord record;
    Records out;
    for (;;) {
        const auto more = reader.next(record);
        EXPECT_TRUE(more);
        if (!more || !*more) return out;
        out.push_back(record.fields);
    }
}

TEST(Csv, ReadsFieldsQuotesAndEitherLineEnd) {
    EXPECT_EQ(records("a,b\r\n1,\n"), (Records{{"a", "b"}, {"1", ""}}));
    EXPECT_EQ(records("\"a,b\",\"say \"\"x\"\"\",\"two\nlines\""),
              (Records{{"a,b", "say \"x\"", "two\nlines"}}));
    EXPECT_EQ(records("\xEF\xBB\xBFx\n\n\ny"), (Records{{"x"}, {"y"}}));
    EXPECT_EQ(records(""), Records{});
    EXPECT_EQ(records(",,"), (Records{{"", "", ""}}));
}

TEST(Csv, NamesTheLineOfAQuoteThatIsNotClosedOrFollowedByText) {
    for (const auto& [text, line] : {std::pair{"a\n\"b\nc", "line 2"}, {"a\n\"b\"c", "line 2"}}) {
        CsvReader reader(text);
        CsvRecord record;
        ASSERT_TRUE(reader.next(record));
        const auto broken = reader.next(record);
        ASSERT_FALSE(broken);
        EXPECT_EQ(broken.error().where, line);
        EXPECT_EQ(broken.error().code, ErrorCode::input_invalid);
    }
}

TEST(Csv, KnowsTheLineOfARecordBehindOneOfSeveralLines) {
    CsvReader reader("\"a\nb\"\nc");
    CsvRecord record;
    ASSERT_TRUE(reader.next(record));
    EXPECT_EQ(record.line, 1U);
    ASSERT_TRUE(reader.next(record));
    EXPECT_EQ(record.line, 3U);
}

TEST(Csv, QuotesWhatNeedsItAndDisarmsFormulas) {
    EXPECT_EQ(csv_field("plain"), "plain");
    EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
    EXPECT_EQ(csv_field("say \"x\""), "\"say \"\"x\"\"\"");
    EXPECT_EQ(csv_field("=1+1"), "'=1+1");
    EXPECT_EQ(csv_field("-1.5"), "-1.5");
}

}  // namespace
}  // namespace facet::base
