// Text helpers: escaping, nearest names, numbers.
// SPDX-License-Identifier: MIT
#include "base/text.h"

#include <gtest/gtest.h>

namespace facet::base {
namespace {

TEST(Escaped, ControlCharactersCannotReachTheTerminal) {
    EXPECT_EQ(escaped("a\x1b[31mb\n\x7f"), "a\\x1b[31mb\\x0a\\x7f");
    EXPECT_EQ(escaped("\xc2\x9b"), "\\x9b");  // C1, as UTF-8
}
TEST(Escaped, MarksThatReorderTextAreSpelledOut) {
    EXPECT_EQ(escaped("a\u202eb\u2066c"), "a\\u202eb\\u2066c");
}
TEST(Escaped, BytesThatAreNotUtf8AreSpelledOut) {
    EXPECT_EQ(escaped("\xff\xc3"), "\\xff\\xc3");
    EXPECT_EQ(escaped("\xc0\xaf"), "\\xc0\\xaf");           // overlong slash
    EXPECT_EQ(escaped("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
}
TEST(Escaped, ProperUtf8StaysAsItIs) { EXPECT_EQ(escaped("шлем 🪖"), "шлем 🪖"); }
TEST(Escaped, LongTextIsCutWithDots) {
    const std::string cut = escaped(std::string(500, 'x'));
    EXPECT_TRUE(cut.ends_with("...")) << cut;
    EXPECT_LE(cut.size(), 130U);
}

TEST(EditDistance, CountsInsertionsDeletionsAndChanges) {
    EXPECT_EQ(edit_distance("", "abc"), 3U);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
    EXPECT_EQ(edit_distance("same", "same"), 0U);
}
TEST(EditDistance, IsSymmetric) {
    for (const auto& [a, b] : {std::pair{"roughness", "rougness"}, {"", "x"}, {"abc", "cab"}})
        EXPECT_EQ(edit_distance(a, b), edit_distance(b, a)) << a << " " << b;
}

TEST(Nearest, FindsTheNameMeant) {
    const std::vector<std::string> names{"--aperture", "--aov", "--background"};
    EXPECT_EQ(nearest("--apperture", names), std::vector<std::string>{"--aperture"});
    EXPECT_EQ(nearest("--back", names), std::vector<std::string>{"--background"});
    EXPECT_TRUE(nearest("--xyzzy", names).empty());
}
TEST(Nearest, NamesTheNearestFirst) {
    const std::vector<std::string> names{"studios", "studio"};
    EXPECT_EQ(nearest("studo", names).front(), "studio");
}

TEST(ParseNumber, TakesWholeFiniteNumbersOnly) {
    EXPECT_EQ(parse_number("1.5"), 1.5);
    EXPECT_EQ(parse_number("+2e3"), 2000.0);
    EXPECT_EQ(parse_number("-0.25"), -0.25);
    for (const char* text :
         {"", " 1", "1 ", "1x", "0x10", "nan", "inf", "-inf", "1e999", "+-1", "++1", "1,5"})
        EXPECT_FALSE(parse_number(text)) << text;
}
TEST(ParseInteger, RefusesWhatDoesNotFit) {
    EXPECT_EQ(parse_integer("-7"), -7);
    for (const char* text : {"", "1.0", "99999999999999999999", "seven"})
        EXPECT_FALSE(parse_integer(text)) << text;
}

TEST(Split, KeepsEmptyPieces) {
    EXPECT_EQ(split("a,,b", ','), (std::vector<std::string_view>{"a", "", "b"}));
    EXPECT_EQ(split("", ',').size(), 1U);
}
TEST(Trimmed, DropsBlanksAtBothEnds) {
    EXPECT_EQ(trimmed(" \t a b\n"), "a b");
    EXPECT_EQ(trimmed(" \n"), "");
}

}  // namespace
}  // namespace facet::base
