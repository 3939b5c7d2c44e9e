// The exit statuses: the table, and what the errors map to.
// SPDX-License-Identifier: MIT
#include "tables/exit_codes.h"

#include "base/result.h"

#include <gtest/gtest.h>

#include <set>

namespace facet::tables {
namespace {

TEST(ExitCodes, NumbersAreDistinctAndFitAStatus) {
    std::set<int> seen;
    for (const ExitRow& row : exit_codes) {
        EXPECT_TRUE(seen.insert(row.number).second) << row.key;
        EXPECT_GE(row.number, 0) << row.key;
        EXPECT_LE(row.number, 255) << row.key;
    }
}
TEST(ExitCodes, EveryErrorEndsWithTheRowOfItsName) {
    using base::ErrorCode;
    const std::pair<ErrorCode, const char*> pairs[] = {
        {ErrorCode::usage, "usage"},
        {ErrorCode::input_invalid, "input_invalid"},
        {ErrorCode::feature_missing, "feature_missing"},
        {ErrorCode::limit_reached, "limit_reached"},
        {ErrorCode::no_backend, "no_backend"},
        {ErrorCode::internal, "internal"},
        {ErrorCode::temporary, "temporary"},
    };
    for (const auto& [code, name] : pairs) EXPECT_EQ(exit_name(base::exit_code(code)), name);
}
TEST(ExitCodes, AreTheContracts) {
    EXPECT_EQ(static_cast<int>(Exit::done), 0);
    EXPECT_EQ(static_cast<int>(Exit::not_held), 1);
    EXPECT_EQ(static_cast<int>(Exit::usage), 2);
    EXPECT_EQ(static_cast<int>(Exit::no_backend), 6);
    EXPECT_EQ(static_cast<int>(Exit::internal), 70);
    EXPECT_EQ(static_cast<int>(Exit::temporary), 75);
}

}  // namespace
}  // namespace facet::tables
