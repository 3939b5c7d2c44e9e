// Broken glTF documents and what must be said of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "gltf_fixture.h"

namespace facet::test {

using base::ErrorCode;

/// A change that breaks a sound document, and what must be said of it.
struct Fault {
    const char* name;
    std::function<void(Document&)> break_it;
    ErrorCode code;
    std::string where;
};

inline void expect_fault(const Fault& fault) {
    SCOPED_TRACE(fault.name);
    Document d = triangle();
    fault.break_it(d);
    const auto loaded = load_document(d);
    ASSERT_FALSE(loaded) << "loads";
    EXPECT_EQ(loaded.error().code, fault.code) << base::to_line(loaded.error());
    EXPECT_EQ(loaded.error().where, fault.where) << base::to_line(loaded.error());
    EXPECT_EQ(loaded.error().file, "test.gltf");
    EXPECT_FALSE(loaded.error().what.empty());
}

inline constexpr ErrorCode invalid = ErrorCode::input_invalid;

}  // namespace facet::test
