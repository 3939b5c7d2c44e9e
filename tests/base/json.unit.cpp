// Where something stands in a JSON text.
// SPDX-License-Identifier: MIT
#include "base/json.h"

#include <gtest/gtest.h>

namespace facet::base {
namespace {

constexpr std::string_view document = R"({
  "a": [1, {"b/c": "x}]", "k\u0065y": 2}],
  "d": {"e": 1, "f": 2, "e": 3}
})";

std::string place(std::string_view pointer, std::size_t occurrence = 0) {
    const auto found = json_place(document, pointer, occurrence);
    return found ? std::to_string(found->line) + ":" + std::to_string(found->column) : "none";
}

TEST(JsonPlace, FindsKeysAndElements) {
    EXPECT_EQ(place(""), "1:1");
    EXPECT_EQ(place("/a"), "2:3");
    EXPECT_EQ(place("/a/0"), "2:9");
    EXPECT_EQ(place("/a/1"), "2:12");
    EXPECT_EQ(place("/a/1/b~1c"), "2:13");
    EXPECT_EQ(place("/a/1/key"), "2:27");
    EXPECT_EQ(place("/d/f"), "3:17");
    EXPECT_EQ(place("/d/e"), "3:9");
    EXPECT_EQ(place("/d/e", 1), "3:25");
}

TEST(JsonPlace, HasNoneForWhatIsNotThere) {
    for (const char* pointer : {"/b", "/a/2", "/a/x", "/a/0/0", "/d/e/f", "a", "/a/99999999999"})
        EXPECT_EQ(place(pointer), "none") << pointer;
    EXPECT_EQ(place("/d/e", 2), "none");
    for (std::size_t cut = 0; cut < document.size(); ++cut)
        static_cast<void>(json_place(document.substr(0, cut), "/d/f"));
}

TEST(ParseJson, NamesTheDuplicate) {
    const auto parsed = parse_json<nlohmann::ordered_json>(document, Limits{});
    ASSERT_FALSE(parsed);
    EXPECT_EQ(parsed.error().what, "duplicate key");
    EXPECT_EQ(parsed.error().where, "/d/e");
}

TEST(ParseJson, HoldsItsLimits) {
    Limits limits;
    limits.json_values = 10;
    EXPECT_EQ(parse_json<nlohmann::json>("[1,2,3,4,5,6,7,8,9,10]", limits).error().code,
              ErrorCode::limit_reached);
    const std::string deep(100'000, '[');
    EXPECT_EQ(parse_json<nlohmann::json>(deep, Limits{}).error().code, ErrorCode::limit_reached);
    EXPECT_EQ(parse_json<nlohmann::json>("[1e999]", Limits{}).error().what, "number does not fit");
}

}  // namespace
}  // namespace facet::base
