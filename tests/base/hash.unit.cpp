// SHA-256 against FIPS 180-4's own examples, and the cache that is asked by name.
// SPDX-License-Identifier: MIT
#include "base/hash.h"

#include "base/build_id.h"
#include "base/lru_cache.h"

#include <gtest/gtest.h>

namespace facet::base {
namespace {

std::string hash_of(std::string_view text) { return sha256_hex(std::as_bytes(std::span(text))); }

TEST(Sha256, IsThatOfTheStandard) {
    EXPECT_EQ(hash_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(hash_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(hash_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Sha256, TellsTextsApartByTheirLengths) {
    Sha256 one;
    one.add_text("ab");
    one.add_text("c");
    Sha256 other;
    other.add_text("a");
    other.add_text("bc");
    EXPECT_NE(one.hex(), other.hex());
}

TEST(LruCache, ForgetsWhatWasAskedForLongestAgo) {
    LruCache<int> cache(30);
    for (const int i : {1, 2, 3}) cache.put(std::to_string(i), std::make_shared<const int>(i), 10);
    ASSERT_NE(cache.find("1"), nullptr);
    cache.put("4", std::make_shared<const int>(4), 10);
    EXPECT_EQ(cache.find("2"), nullptr);
    EXPECT_NE(cache.find("1"), nullptr);
    cache.put("huge", std::make_shared<const int>(5), 31);
    EXPECT_NE(cache.find("huge"), nullptr);
    EXPECT_NE(cache.find("1"), nullptr) << "what is worked on stays beside what comes next";
    EXPECT_EQ(cache.find("4"), nullptr);
}

TEST(BuildId, IsHexadecimal) {
    const std::string id = build_id();
    EXPECT_EQ(id.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_EQ(id, build_id());
}

}  // namespace
}  // namespace facet::base
